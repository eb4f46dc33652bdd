#pragma once

#include "sim/effect.h"

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QObject>
#include <QString>

#include <array>

class QApplication;

namespace app {

/// The colours of one scheme, by role.
struct Tokens
{
    QColor win, panel, scene;                    ///< header and status bar, docks, scene and inputs
    QColor sunk, hover;                          ///< selected row, hovered button
    QColor line, line2, ctl;                     ///< dividers, input frames, empty boxes
    QColor ink, ink2, ink3;                      ///< text, labels and icons, captions
    QColor button, buttonText;                   ///< Play, Next
    QColor now, nowText, wash, wash2;            ///< the present: head, code line, its region
    QColor link, ok, near, past;                 ///< links, ticks, warnings, failures
    QColor body, bodyInk, ghost, dots;           ///< creature, its eyes, the old run, the grid
    QColor keyword, number, type, comment, chip; ///< code
    QColor spring, gravity, damping, contact, driver, wind, stick; ///< kinds of effects
    /// Methods in plots, by family: Euler, Verlet, Runge-Kutta, adaptive, implicit; three shades each. Shape and label
    /// tell them apart, too.
    std::array<std::array<QColor, 3>, 5> methods;
};

enum class Scheme { light, dark };

/// Fonts, colours and icons of the program. Widgets keep a reference and repaint on changed().
class Theme : public QObject
{
    Q_OBJECT

public:
    explicit Theme(Scheme scheme, QObject *parent = nullptr);

    Scheme scheme() const { return m_scheme; }
    void setScheme(Scheme scheme);
    const Tokens &tokens() const { return m_tokens; }
    QColor kindColor(sim::Kind kind) const;

    /// Inter; `pixels` as designed.
    QFont ui(double pixels = 13, QFont::Weight weight = QFont::Normal) const;
    /// Hack, for code and for numbers that change.
    QFont mono(double pixels = 12) const;

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
