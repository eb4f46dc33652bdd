// SUNDIALS' CVODE in the race of creature_in_air.h.

#include "tests/bench/peers/creature_in_air.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace bench::air;

constexpr int size = 4 * points;
const double c = -std::log(damp);

int system(double, N_Vector now, N_Vector change, void *)
{
    Row<double> from, to;
    std::copy_n(N_VGetArrayPointer(now), size, from.begin());
    rates(from, to, c);
    std::copy_n(to.begin(), size, N_VGetArrayPointer(change));
    return 0;
}

/// A solver with CVODE, initialised once and restarted for each run.
class Cvode : public Solver
{
public:
    Cvode(int formulas, double tolerance)
    {
        SUNContext_Create(nullptr, &m_context);
        m_now = N_VNew_Serial(size, m_context);
        m_memory = CVodeCreate(formulas, m_context);
        setStart();
        CVodeInit(m_memory, system, 0.0, m_now);
        CVodeSStolerances(m_memory, 0.0, tolerance);
        CVodeSetMaxNumSteps(m_memory, 1'000'000);
        if (formulas == CV_ADAMS) {
            m_fixedPoint = SUNNonlinSol_FixedPoint(m_now, 0, m_context);
            CVodeSetNonlinearSolver(m_memory, m_fixedPoint);
        } else {
            m_matrix = SUNDenseMatrix(size, size, m_context);
            m_dense = SUNLinSol_Dense(m_now, m_matrix, m_context);
            CVodeSetLinearSolver(m_memory, m_dense, m_matrix);
        }
    }
    Cvode(const Cvode &) = delete;
    Cvode &operator=(const Cvode &) = delete;
    ~Cvode() override
    {
        CVodeFree(&m_memory);
        if (m_fixedPoint)
            SUNNonlinSolFree(m_fixedPoint);
        if (m_dense) {
            SUNLinSolFree(m_dense);
            SUNMatDestroy(m_matrix);
        }
        N_VDestroy(m_now);
        SUNContext_Free(&m_context);
    }

    void run(MeasureSeries &series) override
    {
        setStart();
        CVodeReInit(m_memory, 0.0, m_now);
        write(series[0]);
        for (std::size_t frame = 1; frame <= frames; ++frame) {
            double reached = 0.0;
            const int answer = CVode(m_memory, static_cast<double>(frame), m_now, &reached, CV_NORMAL);
            if (answer < 0)
                N_VConst(HUGE_VAL, m_now); // CVODE failed: count the run as too inaccurate for any target
            write(series[frame]);
        }
    }

private:
    void setStart()
    {
        const Row<double> row = start();
        std::copy(row.begin(), row.end(), N_VGetArrayPointer(m_now));
    }
    void write(std::array<double, 2 * points> &row)
    {
        std::copy_n(N_VGetArrayPointer(m_now), row.size(), row.begin());
    }

    SUNContext m_context = nullptr;
    N_Vector m_now = nullptr;
    void *m_memory = nullptr;
    SUNNonlinearSolver m_fixedPoint = nullptr;
    SUNMatrix m_matrix = nullptr;
    SUNLinearSolver m_dense = nullptr;
};

int enterCvode(const char *name, int formulas)
{
    return enter({"cvode", name, tolerancesDownTo(1e-13),
                  [formulas](double tolerance) { return std::make_unique<Cvode>(formulas, tolerance); }});
}

const int entered[] = {
    enterCvode("Adams, functional iteration", CV_ADAMS),
    enterCvode("BDF, Newton", CV_BDF),
};

}
