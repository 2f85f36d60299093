# Flags of our own targets: halfway_flags. -ffp-contract=off keeps rounding the same on every machine.
add_library(halfway_flags INTERFACE)
target_compile_options(halfway_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off
                       -fno-math-errno $<$<BOOL:${HALFWAY_WERROR}>:-Werror>)
# GCC 12 reports an impossible overlap inside std::string's operator+ (its bug 105651).
target_compile_options(halfway_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
option(HALFWAY_WERROR "Treat warnings as errors" OFF)
option(HALFWAY_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
if(HALFWAY_SANITIZE)
  target_compile_options(halfway_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(halfway_flags INTERFACE -fsanitize=address,undefined)
endif()
