// One pose of each law, as printed where it is written down: by prototypes in another language.
#include "verify/studies/programs/subject.hpp"

namespace halfway::verify {
namespace {

using V = Vec3<double>;

/// Loads on b at theta = (0.5, -0.3, 0.7) from P_a = I; of a law without known forces, or an angular one, the
/// moment alone.
struct Golden {
  const char* joint;
  V d, k_f, k_m, f_b, m_b;
};

const V kD(.1, -.2, .3), kF(1, 10, 100), kM(2, 3, 7), kNo(0, 0, 0);
const V kBondD(.1, -.2, 1.1), kBondF(10, 10, 100), kBondM(10, 10, 100);

const Golden kGoldens[] = {
    {"bullet_6dof", kNo, kNo, kM, kNo, {-.125722149, -1.721408748, 4.024902938}},
    {"abaqus_bushing",
     kD,
     kF,
     kM,
     {-1.127862772, -10.641499004, 32.115647163},
     {2.545052905, -.332684559, 6.212332816}},
    {"physx_swing_twist", kNo, kNo, kM, kNo, {.965773701, -1.270243205, 3.760069814}},
    {"jolt_6dof", kNo, kNo, kM, kNo, {.834185462, -2.566069650, 4.099051313}},
    {"lammps_bpm",
     kBondD,
     kBondF,
     kBondM,
     {3.228320733, -1.130040791, 12.001307423},
     {11.793088735, -16.786115272, 76.338509310}},
    {"lammps_bpm_particle",
     kBondD,
     kBondF,
     kBondM,
     {2.017052719, -1.661119896, 12.014862860},
     {11.897423010, -14.546004192, 77.694845122}},
    {"newton_rod", kNo, kNo, kM, kNo, {.991958944, -1.780523598, 4.979185399}},
    {"newton_d6", kNo, kNo, kM, kNo, {.619102764, -3.030146952, 4.250900003}},
    {"mbsim_offdiag", kNo, kNo, kM, kNo, {.671424391, -.290888421, 3.760069814}},
    {"febio_generic", kNo, kNo, kM, kNo, {1.576903047, -2.517739710, 3.206908457}},
    {"yade_line",
     kBondD,
     V(0, 0, 100),
     kBondM,
     {1.091291936, -2.182583873, 12.004211299},
     {11.285714286, -15.571428571, 76.142857143}},
    {"havok", kD, kF, kM, {.1, -2, 30}, {1.100660237, -.985267467, 4.948678718}},
    {"dart_free",
     kD,
     kF,
     kM,
     {-1.481811746, -17.203567349, 24.614050955},
     {.863748372, -2.657009242, 4.244318630}},
    {"ode_amotor", kNo, kNo, kM, kNo, {1.121575377, -3.101685406, 4.364137526}},
};

Finding compared(const Golden& g) {
  reference::Ask ask;
  ask.K_f = g.k_f.asDiagonal();
  ask.K_m = g.k_m.asDiagonal();
  ask.b.x = g.d;
  ask.b.q = reference::quaternion_of(V(.5, -.3, .7));
  const auto q = program_subject(g.joint)(ask);
  Measurement worst;
  for (int i = 0; i < 3; ++i) {
    worst.include(std::abs(q[6 + i] - g.f_b[i]), fmt::format("f_b[{}]", i));
    worst.include(std::abs(q[9 + i] - g.m_b[i]), fmt::format("m_b[{}]", i));
  }
  return program_finding("golden", g.joint)
      .measured(worst)
      .in("N, N m")
      .at_most(6e-10, "printed with nine decimals: half a unit of the last, and rounding")
      .by(Oracle::printed);
}

}  // namespace

void program_goldens(Checks& checks) {
  for (const Golden& g : kGoldens) {
    checks.push_back(
        {fmt::format("programs/golden/{}", g.joint), "", [&g] { return std::vector{compared(g)}; }});
  }
}

}  // namespace halfway::verify
