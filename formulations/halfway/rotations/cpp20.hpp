// The first line of the library that a compiler reads: one sentence instead of the first word it does not
// know.
#pragma once

#if !(defined(_MSVC_LANG) && _MSVC_LANG >= 202002L) && __cplusplus < 202002L
#error "halfway needs C++20: compile with -std=c++20, or link the CMake target halfway::formulations"
#endif
