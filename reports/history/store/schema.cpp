#include "reports/history/store/store.hpp"

namespace halfway::history {
namespace {

/// Times: a row each run. Other figures: a row where they change.
constexpr const char* kFirst = R"(
create table machine (id integer primary key, cpu text not null, cores integer not null, caches text not null,
  microcode text not null) strict;
create table series (id integer primary key, machine integer not null, compiler text not null, flags text not null,
  build_type text not null, isa text not null) strict;
create table figure (id integer primary key, name text not null unique, unit text not null, kind text not null,
  better text not null, formulation text not null) strict;
create table run (id integer primary key, series integer not null, "commit" text not null, date text not null,
  dirty integer not null, load real, libraries text not null, checksum integer not null,
  repetition_checksum integer, unique (series, "commit", date)) strict;
create table time (run integer not null, figure integer not null, median integer not null, low integer not null,
  high integer not null, n integer not null, primary key (run, figure)) strict, without rowid;
create table change (run integer not null, figure integer not null, value real, comparison text not null,
  expected real, low real, high real, verdict text not null, primary key (run, figure)) strict, without rowid;
create table repetition (run integer not null, figure integer not null, ps text not null,
  primary key (run, figure)) strict, without rowid;
)";

/// A commit says what it did, and which release it is.
constexpr const char* kSecond = R"(
alter table run add column title text not null default '';
alter table run add column release text not null default '';
)";

}  // namespace

const std::string& migration(int from) {
  static const std::string all[kVersion] = {kFirst, kSecond};
  return all[from];
}

}  // namespace halfway::history
