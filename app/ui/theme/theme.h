#pragma once

#include "sim/scene/effect.h"

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QObject>
#include <QString>

#include <array>

class QApplication;
class QPainter;
class QRectF;

namespace app {

/// The colours of one scheme, by role.
struct Tokens
{
    QColor win, panel, scene;          ///< header and status bar, docks, scene and inputs
    QColor sunk, onSunk, hover;        ///< selected entry and its text, hovered button
    QColor well, wellLine;             ///< a card, the ground of a switch, and its edge
    QColor track, computed;            ///< time to come, and what of it is computed
    QColor line, line2, ctl;           ///< dividers, input frames, empty boxes
    QColor ink, ink2, ink3;            ///< text, labels and icons, captions
    QColor button, buttonText;         ///< Play, Next
    QColor now, nowText, wash, wash2;  ///< the present: head, code line, its region
    QColor washLine;                   ///< the frame of the code line; invisible where a wash shows it
    QColor link, ok, near, past;       ///< links, ticks, warnings, failures
    QColor body, bodyInk, ghost, dots; ///< creature, its eyes, the old run, the grid
    QColor keyword, number, type, comment, chip;                   ///< code
    QColor spring, gravity, damping, contact, driver, wind, stick; ///< kinds of effects
    /// Methods in plots, by family: Euler, Verlet, Runge-Kutta, adaptive, implicit; three shades each. Shape and label
    /// tell them apart, too.
    std::array<std::array<QColor, 3>, 5> methods;
};

enum class Scheme { light, dark, highContrast };

/// What lies under a row or a button that stands out.
enum class Surface { hovered, chosen };

/// Fonts, colours and icons of the program. Widgets keep a reference and repaint on changed().
class Theme : public QObject
{
    Q_OBJECT

public:
    explicit Theme(Scheme scheme, QObject *parent = nullptr);

    Scheme scheme() const { return m_scheme; }
    /// Whether what is bright stands on a dark ground.
    bool isDark() const { return m_scheme != Scheme::light; }
    void setScheme(Scheme scheme);
    const Tokens &tokens() const { return m_tokens; }
    QColor kindColor(sim::EffectKind kind) const;

    /// Inter; `pixels` as designed.
    QFont ui(double pixels = 13, QFont::Weight weight = QFont::Normal) const;
    /// Hack, for code and for numbers that change.
    QFont mono(double pixels = 12) const;

    /// Lays the ground for a row or button that is hovered or chosen; leaves the painter without a brush. In high
    /// contrast a frame, so that the colours of kinds keep their contrast on it.
    void paintSurface(QPainter &painter, const QRectF &place, double radius, Surface surface) const;

    /// The icon `name` of assets/icons, in `color` (ink2 if none is given), paler when disabled.
    QIcon icon(const QString &name, const QColor &color = {}) const;

    /// Style, palette, font and style sheet of the whole program.
    void apply(QApplication &application) const;

signals:
    void changed();

private:
    QString styleSheet() const;

    Scheme m_scheme;
    Tokens m_tokens;
};

}
