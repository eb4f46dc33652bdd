#include "sim/methods/adaptive/steps/dop853.h"

#include "sim/methods/adaptive/steps/embedded_runge_kutta.h"

#include <cmath>

namespace sim {

namespace {

//! [dop853_tableau]
/// The time of each stage, as a share of the step.
constexpr Tableau::Row stageTimes = {0.0,
                                     0.05260015195876773,
                                     0.0789002279381516,
                                     0.1183503419072274,
                                     0.2816496580927726,
                                     0.3333333333333333,
                                     0.25,
                                     0.3076923076923077,
                                     0.6512820512820513,
                                     0.6,
                                     0.8571428571428571,
                                     1.0,
                                     1.0,
                                     0.1,
                                     0.2,
                                     0.7777777777777778};
/// The weights of each stage. The last three stages serve the dense output only.
constexpr std::array<Tableau::Row, Tableau::maxStages> stageWeights = {
    {{},
     {0.05260015195876773},
     {0.0197250569845379, 0.0591751709536137},
     {0.02958758547680685, 0, 0.08876275643042054},
     {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792},
     {0.037037037037037035, 0, 0, 0.17082860872947386, 0.12546768756682242},
     {0.037109375, 0, 0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
     {0.03709200011850479, 0, 0, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402,
      0.008273789163814023},
     {0.6241109587160757, 0, 0, -3.3608926294469414, -0.868219346841726, 27.59209969944671,
      20.154067550477894, -43.48988418106996},
     {0.47766253643826434, 0, 0, -2.4881146199716677, -0.590290826836843, 21.230051448181193,
      15.279233632882423, -33.28821096898486, -0.020331201708508627},
     {-0.9371424300859873, 0, 0, 5.186372428844064, 1.0914373489967295, -8.149787010746927,
      -18.52006565999696, 22.739487099350505, 2.4936055526796523, -3.0467644718982196},
     {2.273310147516538, 0, 0, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996,
      -2.8589982771350235, -8.87285693353063, 12.360567175794303, 0.6433927460157636},
     {0.054293734116568765, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585,
      0.3111643669578199, -0.1521609496625161, 0.20136540080403034, 0.04471061572777259},
     {0.056167502283047954, 0, 0, 0, 0, 0, 0.25350021021662483, -0.2462390374708025, -0.12419142326381637,
      0.15329179827876568, 0.00820105229563469, 0.007567897660545699, -0.008298},
     {0.03183464816350214, 0, 0, 0, 0, 0.028300909672366776, 0.053541988307438566, -0.05492374857139099, 0, 0,
      -0.00010834732869724932, 0.0003825710908356584, -0.00034046500868740456, 0.1413124436746325},
     {-0.42889630158379194, 0, 0, 0, 0, -4.697621415361164, 7.683421196062599, 4.06898981839711,
      0.3567271874552811, 0, 0, 0, -0.0013990241651590145, 2.9475147891527724, -9.15095847217987}}};

Tableau eighthOrder()
{
    Tableau t;
    t.stages = 13;
    t.c = stageTimes;
    t.a = stageWeights;
    t.b = t.a[12];
    return t;
}
//! [dop853_tableau]

/// The weights of order 8 minus those of order 5.
constexpr Tableau::Row differenceToOrder5 = {0.01312004499419488,
                                             0,
                                             0,
                                             0,
                                             0,
                                             -1.2251564463762044,
                                             -0.4957589496572502,
                                             1.6643771824549864,
                                             -0.35032884874997366,
                                             0.3341791187130175,
                                             0.08192320648511571,
                                             -0.022355307863886294};
/// The weights of order 8 minus those of order 3.
constexpr Tableau::Row differenceToOrder3 = {-0.18980075407240762,
                                             0,
                                             0,
                                             0,
                                             0,
                                             4.450312892752409,
                                             1.8915178993145003,
                                             -5.801203960010585,
                                             -0.4226823213237919,
                                             -0.1521609496625161,
                                             0.20136540080403034,
                                             0.02265179219836082};
/// The stage weights of the four highest coefficients of the dense output.
constexpr std::array<Tableau::Row, 4> highestCoefficients = {
    {{-8.428938276109013, 0, 0, 0, 0, 0.5667149535193777, -3.0689499459498917, 2.38466765651207,
      2.117034582445028, -0.871391583777973, 2.2404374302607883, 0.6315787787694688, -0.08899033645133331,
      18.148505520854727, -9.194632392478356, -4.436036387594894},
     {10.427508642579134, 0, 0, 0, 0, 242.28349177525817, 165.20045171727028, -374.5467547226902,
      -22.113666853125306, 7.733432668472264, -30.674084731089398, -9.332130526430229, 15.697238121770845,
      -31.139403219565178, -9.35292435884448, 35.81684148639408},
     {19.985053242002433, 0, 0, 0, 0, -387.0373087493518, -189.17813819516758, 527.8081592054236,
      -11.57390253995963, 6.8812326946963, -1.0006050966910838, 0.7777137798053443, -2.778205752353508,
      -60.19669523126412, 84.32040550667716, 11.99229113618279},
     {-25.69393346270375, 0, 0, 0, 0, -154.18974869023643, -231.5293791760455, 357.6391179106141,
      93.40532418362432, -37.45832313645163, 104.0996495089623, 29.8402934266605, -43.53345659001114,
      96.32455395918828, -39.17726167561544, -149.72683625798564}}};

/// The pair with its dense output: polynomials of degree 7 in the position and in the undamped velocity u
/// (see StageWeights). All stages determine them.
class Dop853Pair : public EmbeddedPair
{
public:
    const Tableau &tableau() const override { return m_tableau; }
    int order() const override { return 8; }
    const Tableau::Row &error() const override { return differenceToOrder5; }
    const Tableau::Row &lowerError() const override { return differenceToOrder3; }
    bool hasLowerError() const override { return true; }
    int extraStages() const override { return 3; }
    int denseColumns() const override { return 16; }

    void makeDense(const StepData &step, const double *endX, const double *endV,
                   double *columns) const override
    {
        Tableau::Row undamped{};
        for (std::size_t j = 0; j < undamped.size(); ++j)
            undamped[j] = step.rate == 0.0 ? 1.0 : 1.0 / step.keep[j];
        Tableau::Row ones{};
        ones.fill(1.0);
        fill(step, step.x, endX, 1.0, step.velocities, ones, columns);
        fill(step, step.v, endV, undamped[12], step.accelerations, undamped, columns + 8 * step.size);
    }

    void dense(const double *columns, int size, int first, int end, const DenseTime &time, double *x,
               double *v) const override
    {
        for (int i = first; i < end; ++i) {
            x[i - first] = value(columns + i, size, time.theta);
            v[i - first] = time.kept * value(columns + 8 * size + i, size, time.theta);
        }
    }

private:
    /// Computes eight columns of coefficients for numbers that go from `start` to `share` times `end`. Their
    /// derivative at stage j is `factors[j]` times column j of `rates`.
    static void fill(const StepData &step, const double *start, const double *end, double share,
                     const double *rates, const Tableau::Row &factors, double *columns)
    {
        const int size = step.size;
        for (int i = step.first; i < step.end; ++i) {
            const double rise = share * end[i] - start[i];
            const double bend = step.h * factors[0] * rates[i] - rise;
            columns[i] = start[i];
            columns[size + i] = rise;
            columns[2 * size + i] = bend;
            columns[3 * size + i] = rise - step.h * factors[12] * rates[12 * size + i] - bend;
        }
        for (int k = 0; k < 4; ++k) {
            Tableau::Row weights = highestCoefficients[static_cast<std::size_t>(k)];
            for (std::size_t j = 0; j < weights.size(); ++j)
                weights[j] *= step.h * factors[j];
            blendRows(columns + (4 + k) * size, rates, 0.0, rates, weights.data(), Tableau::maxStages,
                      step.first, step.end, size);
        }
    }

    /// Returns the polynomial at `theta`. Its nested form multiplies by theta and 1 - theta in turn.
    static double value(const double *column, int size, double theta)
    {
        double sum = 0.0;
        for (int k = 7; k > 0; --k)
            sum = (sum + column[k * size]) * (k % 2 == 1 ? theta : 1 - theta);
        return column[0] + sum;
    }

    Tableau m_tableau = eighthOrder();
};

}

const EmbeddedPair &dop853Pair()
{
    static const Dop853Pair pair;
    return pair;
}

namespace {

const StepRule &dop853Rule()
{
    static const EmbeddedRungeKutta instance(dop853Pair());
    return instance;
}

}

Dop853::Dop853()
    : Adaptive(dop853Rule(), {{"sim/methods/adaptive/steps/embedded_runge_kutta.cpp", "embedded_step"},
                              {"sim/methods/adaptive/steps/dop853.cpp", "dop853_tableau"}})
{
}

}
