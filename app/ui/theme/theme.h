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
    QColor win, panel, scene;                    ///< header and status bar, docks, scene and inputs
    QColor sunk, onSunk, hover;                  ///< selected entry and its text, hovered button
    QColor well, wellLine;                       ///< a card, the background of a switch, and its edge
    QColor track, computed;                      ///< future time, and its computed part
    QColor line, line2, ctl;                     ///< dividers, input frames, empty boxes
    QColor ink, ink2, ink3;                      ///< text, labels and icons, captions
    QColor button, buttonText;                   ///< Play, Next
    QColor now, nowText, wash, wash2;            ///< the current moment: playhead, code line, its region
    QColor washLine;                             ///< the frame of the code line; invisible if a wash marks it
    QColor link, ok, near, past;                 ///< links, ticks, warnings, failures
    QColor body, bodyInk, ghost, dots;           ///< creature, its eyes, the comparison run, the grid
    QColor keyword, number, type, comment, chip; ///< code
    QColor spring, gravity, damping, contact, driver, wind, stick, rule; ///< kinds of effects
    /// Colours of the methods in plots, in three shades for each family: Euler, Verlet, Runge-Kutta,
    /// adaptive, implicit. Shapes and labels also tell the methods apart.
    std::array<std::array<QColor, 3>, 5> methods;
};

enum class Scheme { light, dark, highContrast };

/// The state of a row or button that has a highlighted background.
enum class Surface { hovered, chosen };

/// Fonts, colours and icons of the program. Widgets keep a reference.
class Theme : public QObject
{
    Q_OBJECT

public:
    explicit Theme(Scheme scheme, QObject *parent = nullptr);

    Scheme scheme() const { return m_scheme; }
    /// Returns whether the scheme is light on dark.
    bool isDark() const { return m_scheme != Scheme::light; }
    void setScheme(Scheme scheme);
    const Tokens &tokens() const { return m_tokens; }
    QColor kindColor(sim::EffectKind kind) const;

    /// Returns Inter, the font of the interface, at `pixels` px.
    QFont ui(double pixels = 13, QFont::Weight weight = QFont::Normal) const;
    /// Returns Hack, the font for code and for numbers that change, at `pixels` px.
    QFont mono(double pixels = 12) const;

    /// Paints the background of a row or button that is hovered or chosen, and leaves the painter without a
    /// brush. In high contrast it paints a frame, so that the effect colours keep their contrast.
    void paintSurface(QPainter &painter, const QRectF &place, double radius, Surface surface) const;

    /// Returns the icon `name` of assets/icons in `color` (ink2 if none is given), paler when disabled.
    QIcon icon(const QString &name, const QColor &color = {}) const;

    /// Applies the style, palette, font and style sheet to the whole program.
    void apply(QApplication &application) const;

signals:
    /// The scheme has changed. `Appearance` applies the theme then, so all widgets are repainted; only what a widget has
    /// stored of the theme has to follow.
    void changed();

private:
    QString styleSheet() const;

    Scheme m_scheme;
    Tokens m_tokens;
};

}
