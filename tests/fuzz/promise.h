// A promise that must hold whatever the input is.
#pragma once

#include <cstdlib>
#include <iostream>

inline void promise(bool holds, const char* what) {
  if (!holds) {
    std::cerr << "broken: " << what << '\n';
    std::abort();
  }
}
