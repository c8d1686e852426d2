// A program of its own that finds the emulated instrument through the environment it inherits: prints what is plugged
// in, and what each USBTMC device says of itself.
#include "devices/transport/usbtmc_transport.h"

#include <iostream>

int main() {
  using namespace straightedge::devices;
  const auto devices = listUsbDevices();
  if (!devices) {
    std::cerr << devices.error().error.message() << '\n';
    return 1;
  }
  for (const auto& device : *devices) {
    std::cout << device.name() << '\n';
    if (UsbTmcTransport::interfaceOf(device) == nullptr) {
      continue;
    }
    auto meter = UsbTmcTransport::open(device);
    if (!meter) {
      std::cout << meter.error().error.message() << '\n';
      continue;
    }
    const auto sent = (*meter)->write("*IDN?\n", std::chrono::seconds(60));
    const auto reply = (*meter)->read(std::chrono::seconds(60));
    std::cout << (sent && reply ? *reply : "no answer\n");
  }
  return 0;
}
