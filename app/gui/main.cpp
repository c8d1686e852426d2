#include <cstdio>

int main() {
  std::puts("straightedge " STRAIGHTEDGE_VERSION);
  return 0;
}
