#include "app/ui/theme/theme.h"

#include "app/ui/theme/icons.h"
#include "app/ui/theme/springstep_style.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QHash>
#include <QPainter>
#include <QPalette>
#include <QRegularExpression>

namespace app {

namespace {

Tokens lightTokens()
{
    Tokens t;
    t.win = "#F4F2ED", t.panel = "#FBFAF7", t.scene = "#FFFFFF";
    t.sunk = "#ECE9E2", t.onSunk = "#22262B", t.hover = "#E9E6DE";
    t.well = t.wellLine = t.sunk;
    t.track = t.sunk, t.computed = "#CFCABE";
    t.line = "#E0DCD2", t.line2 = "#CFCABE", t.ctl = "#8B8880";
    t.ink = "#22262B", t.ink2 = "#555B62", t.ink3 = "#6A6F75";
    t.button = "#22262B", t.buttonText = "#FFFFFF";
    t.now = "#F5B301", t.nowText = "#5C3F00", t.wash = "#FFF1C7", t.wash2 = "#FFF8E3",
    t.washLine = QColor(0, 0, 0, 0);
    t.link = "#1450A8", t.ok = "#1B7F5C", t.near = "#B25E00", t.past = "#C0262D";
    t.body = "#2E3B4E", t.bodyInk = "#FFFFFF", t.ghost = "#8C929A", t.dots = "#DCD7CB";
    t.keyword = "#7A3E9D", t.number = "#1D6F5B", t.type = "#2F5D8C", t.comment = "#6A7077",
    t.chip = "#EFECE5";
    t.spring = "#1450A8", t.gravity = "#A83200", t.damping = "#D058C4", t.contact = "#3A3E44";
    t.driver = "#00A070", t.wind = "#6592A4", t.stick = "#A08C00", t.rule = "#7A30E8";
    t.methods = {{{"#7F674D", "#D01B4A", "#A13598"},
                  {"#2A7E6E", "#1A574D", "#548118"},
                  {"#6039EF", "#3B1EB8", "#8A71F4"},
                  {"#1086C6", "#164479", "#3D87CD"},
                  {"#926430", "#64482B", "#837316"}}};
    return t;
}

Tokens darkTokens()
{
    Tokens t;
    t.win = "#17191C", t.panel = "#1C1F22", t.scene = "#131518";
    t.sunk = "#262A2E", t.onSunk = "#E9E7E2", t.hover = "#2A2E33";
    t.well = t.wellLine = t.sunk;
    t.track = t.sunk, t.computed = "#3D4349";
    t.line = "#2B2F34", t.line2 = "#3D4349", t.ctl = "#70767D";
    t.ink = "#E9E7E2", t.ink2 = "#AEB2B6", t.ink3 = "#8D9399";
    t.button = "#E9E7E2", t.buttonText = "#17191C";
    t.now = "#FFC53D", t.nowText = "#2B1E00", t.wash = "#3B3116", t.wash2 = "#2A2516",
    t.washLine = QColor(0, 0, 0, 0);
    t.link = "#7FB8FF", t.ok = "#46C08F", t.near = "#F0A23C", t.past = "#FF6B66";
    t.body = "#E8E3D6", t.bodyInk = "#17191C", t.ghost = "#7A8189", t.dots = "#3A4047";
    t.keyword = "#CBA6F0", t.number = "#8FD0B4", t.type = "#8FBCE8", t.comment = "#858B91",
    t.chip = "#2A2E33";
    t.spring = "#3F97FF", t.gravity = "#EE7A2B", t.damping = "#BC86C2", t.contact = "#E6EBEE";
    t.driver = "#3BA878", t.wind = "#4FD4FF", t.stick = "#E8DE5A", t.rule = "#7A55FF";
    t.methods = {{{"#B9A38C", "#F08FA8", "#D070C8"},
                  {"#5CC8B4", "#2E9C8A", "#A8E05C"},
                  {"#B7A3FF", "#8A74E8", "#D9D0FF"},
                  {"#6CC5F5", "#C8DDF5", "#4A8FD0"},
                  {"#D9B48A", "#B98A5A", "#E6D46A"}}};
    return t;
}

Tokens highContrastTokens()
{
    Tokens t;
    t.win = t.panel = t.scene = "#000000";
    t.sunk = "#FFFFFF", t.onSunk = "#000000", t.hover = "#3A3A3A";
    t.well = "#000000", t.wellLine = "#FFFFFF";
    t.track = "#4A4A4A", t.computed = "#8F8F8F";
    t.line = t.line2 = t.ctl = "#FFFFFF";
    t.ink = t.ink2 = "#FFFFFF", t.ink3 = "#E0E0E0";
    t.button = "#FFFFFF", t.buttonText = "#000000";
    t.now = "#FFD60A", t.nowText = "#000000", t.wash = t.wash2 = "#000000", t.washLine = t.now;
    t.link = "#8CC4FF", t.ok = "#4DE3A8", t.near = "#FFB84D", t.past = "#FF7A75";
    t.body = "#FFFFFF", t.bodyInk = "#000000", t.ghost = "#BFBFBF", t.dots = "#404040";
    t.keyword = t.number = t.type = t.comment = "#FFFFFF";
    t.chip = "#000000";
    t.spring = "#4FA3FF", t.gravity = "#FF8330", t.damping = "#D79BDD", t.contact = "#FFFFFF";
    t.driver = "#35C88C", t.wind = "#6FE0FF", t.stick = "#F2EA60", t.rule = "#944DFF";
    t.methods = darkTokens().methods;
    return t;
}

Tokens tokensOf(Scheme scheme)
{
    switch (scheme) {
    case Scheme::dark:
        return darkTokens();
    case Scheme::highContrast:
        return highContrastTokens();
    case Scheme::light:
        break;
    }
    return lightTokens();
}

QFont found(const char *family, QFontDatabase::SystemFont fallback)
{
    return QFontDatabase::hasFamily(family) ? QFont(family) : QFontDatabase::systemFont(fallback);
}

QFont sized(QFont font, double pixels)
{
    font.setPixelSize(qRound(pixels));
    return font;
}

}

Theme::Theme(Scheme scheme, QObject *parent) : QObject(parent), m_scheme(scheme), m_tokens(tokensOf(scheme))
{
}

void Theme::setScheme(Scheme scheme)
{
    if (scheme == m_scheme)
        return;
    m_scheme = scheme;
    m_tokens = tokensOf(scheme);
    emit changed();
}

QColor Theme::kindColor(sim::EffectKind kind) const
{
    switch (kind) {
    case sim::EffectKind::spring:
        return m_tokens.spring;
    case sim::EffectKind::gravity:
        return m_tokens.gravity;
    case sim::EffectKind::damping:
        return m_tokens.damping;
    case sim::EffectKind::contact:
        return m_tokens.contact;
    case sim::EffectKind::driver:
        return m_tokens.driver;
    case sim::EffectKind::wind:
        return m_tokens.wind;
    case sim::EffectKind::stick:
        return m_tokens.stick;
    case sim::EffectKind::rule:
        return m_tokens.rule;
    case sim::EffectKind::motion:
        break;
    }
    return m_tokens.ink3;
}

QFont Theme::ui(double pixels, QFont::Weight weight) const
{
    // Looked up once, because a font query takes as long as painting some of the text.
    static const QFont inter = found("Inter", QFontDatabase::GeneralFont);
    QFont result = sized(inter, pixels);
    result.setWeight(weight);
    return result;
}

QFont Theme::mono(double pixels) const
{
    static const QFont hack = found("Hack", QFontDatabase::FixedFont);
    return sized(hack, pixels);
}

void Theme::paintSurface(QPainter &painter, const QRectF &place, double radius, Surface surface) const
{
    const bool chosen = surface == Surface::chosen;
    if (m_scheme == Scheme::highContrast && chosen) {
        painter.setPen(QPen(m_tokens.ink, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(place.adjusted(1.0, 1.0, -1.0, -1.0), radius, radius);
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(chosen ? m_tokens.sunk : m_tokens.hover);
    painter.drawRoundedRect(place, radius, radius);
    painter.setBrush(Qt::NoBrush);
}

QIcon Theme::icon(const QString &name, const QColor &color) const
{
    return iconOf(name, color.isValid() ? color : m_tokens.ink2);
}

void Theme::apply(QApplication &application) const
{
    const Tokens &t = m_tokens;
    application.setStyle(new SpringstepStyle(t));
    application.setFont(ui());
    QPalette p;
    p.setColor(QPalette::Window, t.panel);
    p.setColor(QPalette::WindowText, t.ink);
    p.setColor(QPalette::Text, t.ink);
    p.setColor(QPalette::ButtonText, t.ink);
    p.setColor(QPalette::Button, t.panel);
    p.setColor(QPalette::Base, t.scene);
    p.setColor(QPalette::AlternateBase, t.panel);
    p.setColor(QPalette::Highlight, t.sunk);
    p.setColor(QPalette::HighlightedText, t.onSunk);
    p.setColor(QPalette::ToolTipBase, t.panel);
    p.setColor(QPalette::ToolTipText, t.ink);
    p.setColor(QPalette::PlaceholderText, t.ink3);
    p.setColor(QPalette::Link, t.link);
    p.setColor(QPalette::Light, t.line);
    p.setColor(QPalette::Mid, t.line2);
    p.setColor(QPalette::Dark, t.line2);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor pale = t.ink3;
        pale.setAlphaF(0.6F);
        p.setColor(QPalette::Disabled, role, pale);
    }
    application.setPalette(p);
    application.setStyleSheet(styleSheet());
}

QString Theme::styleSheet() const
{
    QFile file(":/app/style.qss");
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString text = QString::fromUtf8(file.readAll());
    const Tokens &t = m_tokens;
    const QHash<QString, QColor> colors = {
        {"win", t.win},
        {"panel", t.panel},
        {"scene", t.scene},
        {"sunk", t.sunk},
        {"onSunk", t.onSunk},
        {"well", t.well},
        {"wellLine", t.wellLine},
        {"hover", t.hover},
        {"modeOn", m_scheme == Scheme::highContrast ? t.sunk : t.panel},
        {"modeOnText", t.onSunk},
        {"line", t.line},
        {"line2", t.line2},
        {"ctl", t.ctl},
        {"ink", t.ink},
        {"ink2", t.ink2},
        {"ink3", t.ink3},
        {"button", t.button},
        {"buttonText", t.buttonText},
        {"now", t.now},
        {"link", t.link},
        {"ok", t.ok},
        {"past", t.past},
    };
    static const QRegularExpression name("@(\\w+)@");
    QString result;
    qsizetype end = 0;
    for (auto found = name.globalMatch(text); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        result += QStringView(text).mid(end, match.capturedStart() - end);
        result += colors.value(match.captured(1)).name();
        end = match.capturedEnd();
    }
    return result + text.mid(end);
}

}
