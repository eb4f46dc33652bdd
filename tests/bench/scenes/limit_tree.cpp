#include "tests/bench/scenes/limit_tree.h"

#include "tests/bench/scenes/lanes.h"

#include <numbers>

namespace bench {

namespace {

constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

/// Returns the value of a polynomial. Coefficients start with the highest power.
template <int size>
Lanes polynomial(Lanes x, const double (&coefficients)[size])
{
    Lanes sum = every(coefficients[0]);
    for (int i = 1; i < size; ++i)
        sum = sum * x + coefficients[i];
    return sum;
}

struct Heading
{
    Lanes cosine, sine;
};

/// Returns the heading of an angle in degrees. It reduces the angle to an eighth of a turn and uses
/// polynomials with errors below 1e-16. Source of the coefficients: S. Moshier, Cephes mathematical library,
/// sin.c.
Heading headingOf(Lanes degrees)
{
    // adding it to a number leaves the nearest whole number in the last bits
    constexpr double whole = 0x1.8p52;
    const Lanes shifted = degrees * (1.0 / 90.0) + whole, quarters = shifted - whole;
    const Lanes x = (degrees - 90.0 * quarters) * (1.0 / degreesPerRadian), z = x * x;
    const Lanes sine = x + x * z *
                               polynomial(z, {1.58962301576546568060e-10, -2.50507477628578072866e-8,
                                              2.75573136213857245213e-6, -1.98412698295895385996e-4,
                                              8.33333333332211858878e-3, -1.66666666666666307295e-1});
    const Lanes cosine =
        1.0 - 0.5 * z +
        z * z *
            polynomial(z, {-1.13585365213876817300e-11, 2.08757008419747316778e-9, -2.75573141792967388112e-7,
                           2.48015872888517045348e-5, -1.38888888888730564116e-3, 4.16666666666665929218e-2});
    const __m256i bits = _mm256_castpd_si256(shifted);
    const Lanes odd = signFromBit(bits, 0);
    return {signedBy(bySign(odd, sine, cosine), signFromBit(bits + 1, 1)),
            signedBy(bySign(odd, cosine, sine), signFromBit(bits, 1))};
}

/// Returns the angle of (x, y) in degrees. It uses the ratio of the smaller to the larger coordinate, and
/// subtracts an eighth of a turn if that is above tan(pi/8). Source of the coefficients: S. Moshier, Cephes
/// mathematical library, atan.c.
Lanes angleOf(Lanes x, Lanes y)
{
    const Lanes wide = sizeOf(x), high = sizeOf(y);
    const Lanes small = smaller(wide, high), large = larger(wide, high);
    const auto eighth = small > 0.41421356237309504880 * large;
    const Lanes t = (eighth ? small - large : small) / (eighth ? small + large : large), z = t * t;
    const Lanes above =
        polynomial(z, {-8.750608600031904122785e-1, -1.615753718733365076637e1, -7.500855792314704667340e1,
                       -1.228866684490136173410e2, -6.485021904942025371773e1});
    const Lanes below =
        polynomial(z, {1.0, 2.485846490142306297962e1, 1.650270098316988542046e2, 4.328810604912902668951e2,
                       4.853903996359136964868e2, 1.945506571482613964425e2});
    Lanes degrees = (t + t * z * above / below) * degreesPerRadian;
    degrees = eighth ? degrees + 45.0 : degrees;
    degrees = high > wide ? 90.0 - degrees : degrees;
    return signedBy(bySign(x, 180.0 - degrees, degrees), y);
}

/// The angles of branches after wind and return to rest, and the positions of their ends.
struct Turned
{
    Lanes angle, x, y;
};

[[gnu::always_inline]] inline Turned turned(Lanes angle, Lanes rest, Lanes scale, Lanes x, Lanes y,
                                            const TreeNumbers &numbers)
{
    const Lanes missing = rest - angle;
    angle = sizeOf(missing) > 1.0 ? angle + missing * (1.0 / numbers.ease) : angle;
    const Lanes reach = scale * numbers.length;
    const Heading before = headingOf(angle);
    const Lanes dx = x + reach * before.cosine - numbers.pointerX;
    const Lanes dy = y + reach * before.sine - numbers.pointerY;
    const Lanes off = angleOf(dx, dy) + numbers.gust - angle;
    const Lanes way = off - 360.0 * nearestWhole(off * (1.0 / 360.0));
    const Lanes share = numbers.strength / (root(dx * dx + dy * dy) * scale * scale);
    angle = sizeOf(way) > 1.0 ? angle + smaller(share, every(1.0)) * way : angle;
    const Heading after = headingOf(angle);
    return {angle, x + reach * after.cosine, y + reach * after.sine};
}

/// Stores four numbers twice each.
void storeTwice(double *to, Lanes values)
{
    store(to, _mm256_permute4x64_pd(values, _MM_SHUFFLE(1, 1, 0, 0)));
    store(to + 4, _mm256_permute4x64_pd(values, _MM_SHUFFLE(3, 3, 2, 2)));
}

[[gnu::always_inline]] inline Turned turnedFrom(const TreeArrays &tree, int first, const TreeNumbers &numbers)
{
    return turned(load(tree.angle + first), load(tree.rest + first), load(tree.scale + first),
                  load(tree.x + first), load(tree.y + first), numbers);
}

/// Computes one branch of the lowest levels, which have fewer than four branches.
[[gnu::noinline]] void bendOne(const TreeArrays &tree, int branch, const TreeNumbers &numbers)
{
    const Turned lanes = turnedFrom(tree, branch, numbers);
    tree.angle[branch] = lanes.angle[0];
    for (int child = 2 * branch + 1; child <= 2 * branch + 2 && child < tree.branches; ++child) {
        tree.x[child] = lanes.x[0];
        tree.y[child] = lanes.y[0];
    }
}

}

void limitFrame(const TreeArrays &tree, const TreeNumbers &numbers)
{
    int i = 0;
    for (; i < 3 && i < tree.branches; ++i)
        bendOne(tree, i, numbers);
    const int parents = tree.branches / 2;
    for (; i < parents; i += 4) {
        const Turned lanes = turnedFrom(tree, i, numbers);
        store(tree.angle + i, lanes.angle);
        storeTwice(tree.x + 2 * i + 1, lanes.x);
        storeTwice(tree.y + 2 * i + 1, lanes.y);
    }
    for (; i < tree.branches; i += 4)
        store(tree.angle + i, turnedFrom(tree, i, numbers).angle);
}

}
