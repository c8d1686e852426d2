#include <cstdio>

int main() {
  std::puts("straightedge-cli " STRAIGHTEDGE_VERSION);
  return 0;
}
