// Flops of one evaluation, by the name of what is evaluated: kept in bench/flops.json, because counting them
// instantiates every joint once more. `halfway_flops record` counts them again; the study `counting` counts
// two live.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace halfway::bench {

/// Of multiplications alone.
inline constexpr const char* kProducts = "/products";

/// invariant/angular/residual, .../kernel, .../kernel/order_1, .../kernel/no_ends: flops of one evaluation;
/// .../no_ends/products: how many of them multiply.
using Flops = std::map<std::string, double>;

/// The kept numbers. Throws std::runtime_error that names the file and what is wrong with it.
const Flops& kept_flops();

/// The kept number; 0 where none is kept: not counted.
double kept_flops(const std::string& name);

/// To a temporary file that takes its name when complete.
void write_flops(const std::filesystem::path& file, const Flops& flops);

}  // namespace halfway::bench
