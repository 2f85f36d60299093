// SIGINT and SIGTERM, asked for where long work can stop: what was started is ended first.
#pragma once

namespace halfway::reports {

/// From here on SIGINT and SIGTERM end nothing: they are remembered.
void catch_interrupts();

/// Was there one?
bool interrupted();

}  // namespace halfway::reports
