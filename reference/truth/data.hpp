// Facts from outside: the paper's tables and MBDyn's results, each folder with its provenance.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace halfway::reference {

/// A data file that cannot be read: names the file and what is wrong.
struct DataError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// $HALFWAY_DATA, or the folder of the sources that was built in.
std::filesystem::path data_folder();

/// A JSON file below it, e.g. read_data("reference/data/mbdyn/table1.json"). Throws DataError.
nlohmann::json read_data(const std::string& relative_path);

}  // namespace halfway::reference
