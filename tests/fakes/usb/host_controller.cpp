#include "tests/fakes/usb/host_controller.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <linux/ioctl.h> // before usbdevice_fs.h, which forgets it
#include <linux/usbdevice_fs.h>
#include <span>
#include <unistd.h>

namespace straightedge::fakes {

namespace {

void answer(UMockdevIoctlClient* client, int error = 0) {
  umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
}

/// What the ioctl's argument points to; owned by `arg` and written back with the answer.
UMockdevIoctlData* pointed(UMockdevIoctlData* arg, std::size_t size) {
  auto* data = umockdev_ioctl_data_resolve(arg, 0, size, nullptr);
  if (data != nullptr) {
    g_object_unref(data); // its parent keeps it
  }
  return data;
}

template <typename T>
T* pointedAs(UMockdevIoctlData* arg) {
  auto* data = pointed(arg, sizeof(T));
  return data == nullptr ? nullptr : reinterpret_cast<T*>(data->data);
}

std::span<std::uint8_t> bytesOf(UMockdevIoctlData* data) {
  return data == nullptr ? std::span<std::uint8_t>() : std::span(data->data, static_cast<std::size_t>(data->data_len));
}

std::uint16_t le16(std::span<const std::uint8_t> at) { return static_cast<std::uint16_t>(at[0] | (at[1] << 8U)); }

} // namespace

HostController::HostController(std::shared_ptr<EmulatedDevice> device, std::string driver,
                               std::function<void()> deviceLeaves)
    : m_device(std::move(device)), m_driver(std::move(driver)), m_deviceLeaves(std::move(deviceLeaves)) {}

std::string HostController::driver(int interfaceNumber) const {
  const auto number = static_cast<unsigned>(interfaceNumber);
  if (m_heldByOther || m_claims.contains(number)) {
    return "usbfs";
  }
  return m_detached.contains(number) ? std::string() : m_driver;
}

bool HostController::handle(UMockdevIoctlClient* client) {
  const auto request = umockdev_ioctl_client_get_request(client);
  auto* arg = umockdev_ioctl_client_get_arg(client);
  if (m_gone && request != USBDEVFS_REAPURBNDELAY && request != USBDEVFS_REAPURB) {
    answer(client, ENODEV);
    return true;
  }
  switch (request) {
  case USBDEVFS_GET_CAPABILITIES:
    *pointedAs<std::uint32_t>(arg) = USBDEVFS_CAP_BULK_SCATTER_GATHER | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                     USBDEVFS_CAP_REAP_AFTER_DISCONNECT | USBDEVFS_CAP_ZERO_PACKET;
    answer(client);
    return true;
  case USBDEVFS_CLAIMINTERFACE:
    claim(client, *pointedAs<unsigned>(arg), false);
    return true;
  case USBDEVFS_DISCONNECT_CLAIM:
    claim(client, pointedAs<usbdevfs_disconnect_claim>(arg)->interface, true);
    return true;
  case USBDEVFS_RELEASEINTERFACE:
    m_claims.erase(*pointedAs<unsigned>(arg));
    answer(client);
    return true;
  case USBDEVFS_GETDRIVER: {
    auto* driverAt = pointedAs<usbdevfs_getdriver>(arg);
    const auto name = driver(static_cast<int>(driverAt->interface));
    std::strncpy(driverAt->driver, name.c_str(), sizeof(driverAt->driver) - 1);
    answer(client, name.empty() ? ENODATA : 0);
    return true;
  }
  case USBDEVFS_IOCTL: {
    const auto* command = pointedAs<usbdevfs_ioctl>(arg);
    const auto number = static_cast<unsigned>(command->ifno);
    if (static_cast<unsigned>(command->ioctl_code) == USBDEVFS_CONNECT) {
      m_detached.erase(number);
    } else if (static_cast<unsigned>(command->ioctl_code) == USBDEVFS_DISCONNECT) {
      m_detached.insert(number);
    }
    answer(client);
    return true;
  }
  case USBDEVFS_CLEAR_HALT: {
    const auto endpoint = static_cast<std::uint8_t>(*pointedAs<unsigned>(arg));
    ++m_device->m_haltsCleared[endpoint];
    m_device->haltCleared(endpoint);
    answer(client);
    return true;
  }
  case USBDEVFS_RESET:
    ++m_device->m_resets;
    m_device->wasReset();
    answer(client);
    return true;
  case USBDEVFS_SETCONFIGURATION:
  case USBDEVFS_SETINTERFACE:
    answer(client);
    return true;
  case USBDEVFS_SUBMITURB:
    submit(client, arg);
    return true;
  case USBDEVFS_DISCARDURB:
    discard(client, arg);
    return true;
  case USBDEVFS_REAPURB:
  case USBDEVFS_REAPURBNDELAY:
    reap(client, arg);
    return true;
  default:
    return false;
  }
}

void HostController::claim(UMockdevIoctlClient* client, unsigned interfaceNumber, bool detach) {
  dropClosedClients();
  const auto it = m_claims.find(interfaceNumber);
  const bool driverInTheWay = !m_driver.empty() && !m_detached.contains(interfaceNumber);
  if (m_heldByOther || (it != m_claims.end() && it->second.owner.get() != client) || (driverInTheWay && !detach)) {
    answer(client, EBUSY);
    return;
  }
  if (driverInTheWay) {
    m_detached.insert(interfaceNumber);
  }
  m_claims[interfaceNumber] = {keep(client), driverInTheWay};
  m_device->wasClaimed();
  answer(client);
}

void HostController::dropClosedClients() {
  const auto closed = [](const auto& client) { return umockdev_ioctl_client_get_connected(client.get()) == FALSE; };
  std::erase_if(m_claims, [&](const auto& claim) { return closed(claim.second.owner); });
  m_urbs.remove_if([&](const Urb& urb) { return closed(urb.client); });
}

void HostController::submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  Urb urb;
  urb.client = keep(client);
  auto* data = pointed(arg, sizeof(usbdevfs_urb));
  urb.data = keep(data);
  urb.urb = reinterpret_cast<usbdevfs_urb*>(data->data);
  if (urb.urb->buffer_length > 0) {
    auto* buffer = umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer),
                                               static_cast<std::size_t>(urb.urb->buffer_length), nullptr);
    g_object_unref(buffer);
    urb.buffer = buffer;
  }
  urb.urb->actual_length = 0;
  urb.urb->status = 0;
  m_urbs.push_back(std::move(urb));
  m_idleReaps = 0;
  pump();
  answer(client);
}

void HostController::discard(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  gulong address = 0;
  std::memcpy(&address, arg->data, sizeof(address));
  for (Urb& urb : m_urbs) {
    if (!urb.done && urb.client.get() == client && urb.data->client_addr == address) {
      urb.done = true;
      urb.urb->status = -ENOENT;
      m_idleReaps = 0;
      answer(client);
      return;
    }
  }
  answer(client, EINVAL);
}

bool HostController::giveDone(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  pump();
  const auto it = std::ranges::find_if(m_urbs, [&](const Urb& urb) { return urb.done && urb.client.get() == client; });
  if (it == m_urbs.end()) {
    return false;
  }
  auto* target = pointed(arg, sizeof(void*));
  umockdev_ioctl_data_set_ptr(target, 0, it->data.get());
  m_urbs.erase(it);
  m_idleReaps = 0;
  answer(client);
  return true;
}

void HostController::reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  if (giveDone(client, arg)) {
    return;
  }
  if (m_gone) {
    answer(client, ENODEV);
    return;
  }
  // The emulated node is always ready, so libusb asks again and again while a transfer waits. A pause after the first
  // few questions spares the processor; a pause at once would slow down every query.
  const bool waiting = std::ranges::any_of(m_urbs, [&](const Urb& urb) { return urb.client.get() == client; });
  if (waiting && ++m_idleReaps > 2) {
    ::usleep(300);
  }
  answer(client, EAGAIN);
}

void HostController::pump() {
  std::set<std::uint8_t> waiting;
  m_device->m_posted.clear();
  for (const Urb& urb : m_urbs) {
    if (!urb.done && (urb.urb->endpoint & 0x80U) != 0) {
      m_device->m_posted.insert(urb.urb->endpoint);
    }
  }
  for (Urb& urb : m_urbs) {
    if (urb.done || waiting.contains(urb.urb->endpoint)) {
      continue;
    }
    urb.done = advance(urb);
    if (!urb.done) {
      waiting.insert(urb.urb->endpoint);
    }
    if (m_device->m_leaving && !m_gone) {
      m_deviceLeaves();
      return;
    }
  }
}

bool HostController::advance(Urb& urb) {
  if (urb.urb->type == USBDEVFS_URB_TYPE_CONTROL) {
    runControl(urb);
    return true;
  }
  if (m_device->isHalted(urb.urb->endpoint)) {
    urb.urb->status = -EPIPE;
    return true;
  }
  return (urb.urb->endpoint & 0x80U) != 0 ? advanceIn(urb) : advanceOut(urb);
}

bool HostController::advanceOut(Urb& urb) {
  const auto all = bytesOf(urb.buffer);
  const std::size_t size = m_device->packetSize(urb.urb->endpoint);
  do {
    const auto from = static_cast<std::size_t>(urb.urb->actual_length);
    const auto piece = all.subspan(from, std::min(size, all.size() - from));
    switch (m_device->packetOut(urb.urb->endpoint, Bytes(piece.begin(), piece.end()))) {
    case Handshake::Nak:
      return false;
    case Handshake::Stall:
      m_device->halt(urb.urb->endpoint);
      urb.urb->status = -EPIPE;
      return true;
    case Handshake::Ack:
      urb.urb->actual_length += static_cast<int>(piece.size());
    }
  } while (static_cast<std::size_t>(urb.urb->actual_length) < all.size());
  return true;
}

bool HostController::advanceIn(Urb& urb) {
  const auto all = bytesOf(urb.buffer);
  const std::size_t size = m_device->packetSize(urb.urb->endpoint);
  while (true) {
    const auto packet = m_device->packetIn(urb.urb->endpoint);
    if (m_device->isHalted(urb.urb->endpoint)) {
      urb.urb->status = -EPIPE;
      return true;
    }
    if (!packet) {
      return false;
    }
    const auto at = static_cast<std::size_t>(urb.urb->actual_length);
    if (packet->size() > size || packet->size() > all.size() - at) {
      urb.urb->status = -EOVERFLOW;
      return true;
    }
    std::ranges::copy(*packet, all.subspan(at).begin());
    urb.urb->actual_length += static_cast<int>(packet->size());
    if (packet->size() < size || static_cast<std::size_t>(urb.urb->actual_length) == all.size()) {
      return true;
    }
  }
}

void HostController::runControl(Urb& urb) {
  const auto all = bytesOf(urb.buffer);
  const ControlSetup setup{.requestType = all[0],
                           .request = all[1],
                           .value = le16(all.subspan(2)),
                           .index = le16(all.subspan(4)),
                           .length = le16(all.subspan(6))};
  const bool in = (setup.requestType & 0x80U) != 0;
  const auto data = all.subspan(8);
  const auto reply = m_device->control(setup, in ? Bytes() : Bytes(data.begin(), data.end()));
  if (!reply) {
    urb.urb->status = -EPIPE;
    return;
  }
  const std::size_t count = in ? std::min(reply->size(), data.size()) : data.size();
  if (in) {
    std::ranges::copy_n(reply->begin(), static_cast<std::ptrdiff_t>(count), data.begin());
  }
  urb.urb->actual_length = static_cast<int>(count);
}

void HostController::deviceGone() {
  m_gone = true;
  for (Urb& urb : m_urbs) {
    if (!urb.done) {
      urb.done = true;
      urb.urb->status = -ESHUTDOWN;
    }
  }
}

} // namespace straightedge::fakes
