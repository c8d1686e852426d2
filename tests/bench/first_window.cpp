// Starts a program on an X display and says how long it takes until its first window shows something, and how much
// memory it holds then: "MILLISECONDS MEGABYTES". Any program, so that ours is measured like everybody else's.
// usage: bench_first_window PROGRAM [ARGUMENT...]

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds patience{30};
constexpr int smallestSide = 150; // splash screens and helper windows do not count

// Windows come and go while we look at them.
int ignoreError(Display* /*display*/, XErrorEvent* /*event*/) { return 0; }

bool severalColours(Display* display, Window window, int x, int y, int width, int height) {
  XImage* image =
      XGetImage(display, window, x, y, static_cast<unsigned>(width), static_cast<unsigned>(height), AllPlanes, ZPixmap);
  if (image == nullptr) {
    return false;
  }
  bool several = false;
  const unsigned long first = XGetPixel(image, 0, 0);
  for (int j = 0; j < height && !several; ++j) {
    for (int i = 0; i < width && !several; ++i) {
      several = XGetPixel(image, i, j) != first;
    }
  }
  XDestroyImage(image);
  return several;
}

/// Whether some window below `parent` shows more than one colour along its middle row or column.
bool painted(Display* display, Window parent, int depth) {
  Window root = 0;
  Window up = 0;
  Window* children = nullptr;
  unsigned count = 0;
  if (XQueryTree(display, parent, &root, &up, &children, &count) == 0) {
    return false;
  }
  bool found = false;
  for (unsigned i = 0; i < count && !found; ++i) {
    XWindowAttributes attributes{};
    if (XGetWindowAttributes(display, children[i], &attributes) == 0 || attributes.map_state != IsViewable) {
      continue;
    }
    const bool large = attributes.width >= smallestSide && attributes.height >= smallestSide;
    found = attributes.override_redirect == 0 && large &&
            (severalColours(display, children[i], 0, attributes.height / 2, attributes.width, 1) ||
             severalColours(display, children[i], attributes.width / 2, 0, 1, attributes.height));
    found = found || (depth > 0 && painted(display, children[i], depth - 1));
  }
  if (children != nullptr) {
    XFree(children);
  }
  return found;
}

double residentMegabytes(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) {
      double kilobytes = 0.0;
      std::istringstream(line.substr(6)) >> kilobytes;
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: bench_first_window PROGRAM [ARGUMENT...]\n", stderr);
    return 2;
  }
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) {
    std::fputs("bench_first_window: no X display; start it under Xvfb\n", stderr);
    return 3;
  }
  XSetErrorHandler(ignoreError);
  const auto start = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    execvp(argv[1], argv + 1);
    _exit(127);
  }
  bool seen = false;
  while (!seen && Clock::now() - start < patience && waitpid(child, nullptr, WNOHANG) == 0) {
    seen = painted(display, DefaultRootWindow(display), 1);
    if (!seen) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  const double elapsed = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  if (seen) {
    std::printf("%.1f %.1f\n", elapsed, residentMegabytes(child));
  } else {
    std::fprintf(stderr, "bench_first_window: %s showed no window\n", argv[1]);
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  XCloseDisplay(display);
  return seen ? 0 : 1;
}
