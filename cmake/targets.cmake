# Flags of our own targets, halfway_flags, and their precompiled headers.
# -ffp-contract=off keeps rounding the same on every machine.
add_library(halfway_flags INTERFACE)
target_compile_options(halfway_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off
                       -fno-math-errno $<$<BOOL:${HALFWAY_WERROR}>:-Werror>)
# GCC 12 reports an impossible overlap inside std::string's operator+ (its bug 105651).
target_compile_options(halfway_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Eigen and the standard library are half of a small unit's compile time: precompiled once for all targets
# of the same options: verify takes reference's, reports those of reference_fe, which have JSON as well.
function(shared_headers target)
  target_precompile_headers(${target} PRIVATE <Eigen/Geometry> <Eigen/LU> <array> <cmath> <functional> <optional>
                            <string> <variant> <vector> ${ARGN})
endfunction()

option(HALFWAY_WERROR "Treat warnings as errors" OFF)
option(HALFWAY_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
if(HALFWAY_SANITIZE)
  target_compile_options(halfway_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(halfway_flags INTERFACE -fsanitize=address,undefined)
endif()
