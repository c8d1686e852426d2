// What a USBTMC query costs the host, without the device: the protocol alone, and with the real libusb on a kernel that
// answers at once. The second needs umockdev to have a device to open; its ioctls are then answered here, in the
// process. Run with LD_PRELOAD=libumockdev-preload.so.0.
#include "devices/transport/usbtmc_transport.h"
#include "tests/fakes/usb/emulated_usb.h"
#include "tests/fakes/usb/usbtmc_device.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <dlfcn.h>
#include <linux/ioctl.h>
#include <linux/usbdevice_fs.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

using namespace straightedge::devices;
constexpr std::string_view reply = "0.012345 T,-0.234567 T,0.345678 T\n";
constexpr std::chrono::seconds deadline(5);

/// Fills a reply to the request whose tag was seen last.
std::size_t fillReply(std::uint8_t tag, std::uint8_t* to) {
  const auto size = static_cast<std::uint32_t>(reply.size());
  const auto header = usbtmc::messageHeader(tag, size, true);
  std::ranges::copy(header, to);
  to[0] = 2;
  std::memcpy(to + header.size(), reply.data(), reply.size());
  return header.size() + reply.size();
}

class InstantPipe final : public UsbPipe {
public:
  std::string name() const override { return "instant"; }
  UsbResult<std::size_t> bulkOut(std::uint8_t, std::span<const std::uint8_t> bytes,
                                 std::chrono::milliseconds) override {
    m_tag = bytes[1];
    return bytes.size();
  }
  UsbResult<std::size_t> bulkIn(std::uint8_t, std::span<std::uint8_t> buffer, std::chrono::milliseconds) override {
    return fillReply(m_tag, buffer.data());
  }
  UsbResult<std::size_t> control(const UsbSetup&, std::span<std::uint8_t>, std::chrono::milliseconds) override {
    return std::unexpected(UsbError{.fault = UsbFault::Stalled, .error = {}});
  }
  UsbResult<void> clearHalt(std::uint8_t) override { return {}; }
  UsbResult<void> reset() override { return {}; }
  UsbResult<void> startReading(std::uint8_t, std::size_t, std::size_t) override { return {}; }
  UsbResult<std::vector<std::uint8_t>> nextRead(std::uint8_t, std::chrono::milliseconds) override {
    return std::unexpected(UsbError{.fault = UsbFault::TimedOut, .error = {}});
  }

private:
  std::uint8_t m_tag = 0;
};

void ask(benchmark::State& state, UsbTmcTransport& meter) {
  for (auto _ : state) {
    const auto sent = meter.write(":FETC:X?;:FETC:Y?;:FETC:Z?\n", deadline);
    const auto answer = meter.read(deadline);
    if (!sent || !answer || *answer != reply) {
      state.SkipWithError("the query was not answered");
      return;
    }
  }
}

void BM_UsbTmcQueryProtocol(benchmark::State& state) {
  const UsbTmcChannel channel{.interfaceNumber = 0,
                              .out = {.address = 1, .packetSize = 512},
                              .in = {.address = 0x82, .packetSize = 512},
                              .interrupt = std::nullopt};
  auto meter = UsbTmcTransport::start(std::make_unique<InstantPipe>(), "instant", channel);
  ask(state, **meter);
}
BENCHMARK(BM_UsbTmcQueryProtocol)->Unit(benchmark::kMicrosecond);

/// A kernel that has done every transfer when it is asked for it.
struct InstantKernel {
  bool on = false;
  std::uint8_t tag = 0;
  std::vector<usbdevfs_urb*> done;

  int submit(usbdevfs_urb* urb) {
    auto* bytes = static_cast<std::uint8_t*>(urb->buffer);
    urb->status = 0;
    urb->actual_length = urb->buffer_length;
    if (urb->type == USBDEVFS_URB_TYPE_CONTROL) {
      urb->status = -EPIPE;
      urb->actual_length = 0;
    } else if (urb->type == USBDEVFS_URB_TYPE_INTERRUPT) {
      return 0; // no notification ever comes
    } else if ((urb->endpoint & 0x80U) != 0) {
      urb->actual_length = static_cast<int>(fillReply(tag, bytes));
    } else {
      tag = bytes[1];
    }
    done.push_back(urb);
    return 0;
  }

  int reap(void* target) {
    if (done.empty()) {
      errno = EAGAIN;
      return -1;
    }
    std::memcpy(target, &done.front(), sizeof(void*));
    done.erase(done.begin());
    return 0;
  }
};
InstantKernel kernel;

void BM_UsbTmcQueryWithLibusb(benchmark::State& state) {
  using namespace straightedge::fakes;
  EmulatedUsb bus;
  UsbTmcDevice::Options options;
  options.identity = {0x1234, 0x5678, "Straightedge", "instant", "1"};
  options.interruptEndpoint = false;
  bus.plug(std::make_shared<UsbTmcDevice>(options));
  auto meter = UsbTmcTransport::open(listUsbDevices()->at(0));
  if (!meter) {
    state.SkipWithError("no emulated device");
    return;
  }
  kernel.on = true;
  ask(state, **meter);
  kernel.on = false;
}
BENCHMARK(BM_UsbTmcQueryWithLibusb)->Unit(benchmark::kMicrosecond);

} // namespace

/// In front of libumockdev's and libc's: the program's own symbols come first.
extern "C" int ioctl(int descriptor, unsigned long request, ...) {
  va_list list;
  va_start(list, request);
  void* argument = va_arg(list, void*);
  va_end(list);
  if (kernel.on && request == USBDEVFS_SUBMITURB) {
    return kernel.submit(static_cast<usbdevfs_urb*>(argument));
  }
  if (kernel.on && request == USBDEVFS_REAPURBNDELAY) {
    return kernel.reap(argument);
  }
  if (kernel.on && request == USBDEVFS_CLEAR_HALT) {
    return 0;
  }
  using Next = int (*)(int, unsigned long, void*);
  static const auto next = reinterpret_cast<Next>(::dlsym(RTLD_NEXT, "ioctl"));
  return next(descriptor, request, argument);
}

BENCHMARK_MAIN();
