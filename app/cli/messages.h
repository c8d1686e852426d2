// Everything that straightedge-cli says on standard error: one line each.
#pragma once

#include "core/base/error.h"

#include <string>
#include <string_view>

namespace straightedge::cli {

/// `straightedge-cli: WHERE: WHAT; REMEDY`
void printError(const Error& error);

/// `straightedge-cli: warning: TEXT`
void printWarning(std::string_view text);

/// `straightedge-cli: TEXT`: what a person should know or do while the program runs
void printNote(std::string_view text);

/// Text on standard output; whether it arrived is checked at the end of the program.
void print(std::string_view text);

/// An error of a room that knows a file only by its name, told with the path that was given on the command line.
Error withPath(Error error, const std::string& fileName, const std::string& path);

} // namespace straightedge::cli
