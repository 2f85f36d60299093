#include "reference/truth/fe/cholesky.hpp"

#include <dlfcn.h>
#include <Eigen/CholmodSupport>

namespace halfway::reference::fe {
namespace {

/// Threads of OpenBLAS and of CHOLMOD's OpenMP loops wait for each other by spinning: on a shared machine
/// they cost thirty times what they gain on these small blocks. Looked up at run time, since another BLAS may
/// be behind CHOLMOD, or a build without OpenMP.
void use_one_thread() {
  using Set = void (*)(int);
  if (auto* symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) reinterpret_cast<Set>(symbol)(1);
  if (auto* symbol = dlsym(RTLD_DEFAULT, "omp_set_max_active_levels")) reinterpret_cast<Set>(symbol)(0);
}

}  // namespace

struct Cholesky::Factors {
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> of_K;
  bool analyzed = false;
};

Cholesky::Cholesky() : factors_(std::make_unique<Factors>()) {
  use_one_thread();
  cholmod_common& settings = factors_->of_K.cholmod();
  settings.nmethods = 1;
  settings.method[0].ordering = CHOLMOD_METIS;
  settings.postorder = 1;
  settings.print = 0;
}

Cholesky::~Cholesky() = default;

bool Cholesky::factorize(const Eigen::SparseMatrix<double>& K) {
  if (!factors_->analyzed) factors_->of_K.analyzePattern(K);
  factors_->analyzed = true;
  factors_->of_K.factorize(K);
  return factors_->of_K.info() == Eigen::Success;
}

Eigen::MatrixXd Cholesky::solve(const Eigen::MatrixXd& b) const { return factors_->of_K.solve(b); }

}  // namespace halfway::reference::fe
