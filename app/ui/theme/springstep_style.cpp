#include "app/ui/theme/springstep_style.h"

#include "app/ui/theme/focus_ring.h"
#include "app/ui/theme/icons.h"

#include <QFocusFrame>
#include <QPainter>
#include <QPushButton>
#include <QStyleOption>

namespace app {

namespace {

constexpr int indicator = 16;
constexpr int controlHeight = 26;
constexpr int scrollBar = 10;
constexpr double controlRadius = 6.0;
constexpr double buttonRadius = 8.0;

/// Returns a square with this `side` in the centre of `rect`.
QRectF middle(const QRect &rect, double side)
{
    return {rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2, side, side};
}

}

SpringstepStyle::SpringstepStyle(Tokens tokens) : QProxyStyle("Fusion"), m_tokens(std::move(tokens)) {}

SpringstepStyle::~SpringstepStyle() = default;

void SpringstepStyle::polish(QApplication *application)
{
    QProxyStyle::polish(application);
    if (!m_ring)
        m_ring = std::make_unique<FocusRing>();
}

void SpringstepStyle::unpolish(QApplication *application)
{
    m_ring.reset();
    QProxyStyle::unpolish(application);
}

int SpringstepStyle::pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const
{
    switch (metric) {
    case PM_FocusFrameHMargin:
    case PM_FocusFrameVMargin:
        return FocusRing::gap + FocusRing::width;
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight:
        return indicator;
    case PM_CheckBoxLabelSpacing:
        return 9;
    case PM_ScrollBarExtent:
        return scrollBar;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int SpringstepStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                               QStyleHintReturn *returned) const
{
    switch (hint) {
    case SH_Slider_AbsoluteSetButtons:
        return Qt::LeftButton;
    case SH_FocusFrame_AboveWidget:
        return 1;
    case SH_DialogButtonBox_ButtonsHaveIcons: // those of Fusion, in Qt's own file dialog
    case SH_EtchDisabledText:
    case SH_DitherDisabledText:
    case SH_UnderlineShortcut:
    case SH_ComboBox_Popup:
    case SH_FocusFrame_Mask: // a mask would cut off the ring's corners
        return 0;
    default:
        return QProxyStyle::styleHint(hint, option, widget, returned);
    }
}

void SpringstepStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                                    const QWidget *widget) const
{
    if (element == PE_FrameTabBarBase)
        return; // dock tabs have no base line
    switch (element) {
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
        drawCheckBox(*option, *painter);
        return;
    case PE_IndicatorRadioButton:
        drawRadioButton(*option, *painter);
        return;
    case PE_IndicatorMenuCheckMark:
        if (option->state & State_On)
            iconOf("check", m_tokens.ink).paint(painter, middle(option->rect, 14).toRect());
        return;
    case PE_FrameFocusRect: // the ring round the widget replaces it
    case PE_FrameGroupBox:
    case PE_FrameStatusBarItem:
        return;
    default:
        QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void SpringstepStyle::drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                                  const QWidget *widget) const
{
    if (element == CE_FocusFrame) {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(m_tokens.ink, FocusRing::width));
        painter->setBrush(Qt::NoBrush);
        constexpr double half = FocusRing::width / 2.0;
        const auto *frame = qobject_cast<const QFocusFrame *>(widget);
        const bool isButton = frame && qobject_cast<const QPushButton *>(frame->widget());
        const double radius = (isButton ? buttonRadius : controlRadius) + FocusRing::gap + half;
        painter->drawRoundedRect(QRectF(option->rect).adjusted(half, half, -half, -half), radius, radius);
        painter->restore();
        return;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void SpringstepStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                         QPainter *painter, const QWidget *widget) const
{
    if (control == CC_ComboBox)
        drawComboBox(*option, *painter);
    else
        QProxyStyle::drawComplexControl(control, option, painter, widget);
}

QSize SpringstepStyle::sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                                        const QWidget *widget) const
{
    QSize result = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (type == CT_ComboBox)
        result.setHeight(controlHeight);
    return result;
}

void SpringstepStyle::drawCheckBox(const QStyleOption &option, QPainter &painter) const
{
    const bool on = option.state & State_On;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (!(option.state & State_Enabled))
        painter.setOpacity(0.4);
    const QRectF box = middle(option.rect, indicator);
    painter.setPen(on ? QPen(Qt::NoPen) : QPen(m_tokens.ctl, 1));
    painter.setBrush(on ? m_tokens.ok : m_tokens.scene);
    const double inset = on ? 0.0 : 0.5;
    painter.drawRoundedRect(box.adjusted(inset, inset, -inset, -inset), 5 - inset, 5 - inset);
    if (on) {
        // White on the light scheme's deep green, nearly black on the dark scheme's pale green.
        const QColor tick = m_tokens.panel.lightnessF() > 0.5F ? QColor("#FFFFFF") : QColor("#10201A");
        iconOf("check", tick).paint(&painter, middle(option.rect, 12).toRect());
    }
    painter.restore();
}

void SpringstepStyle::drawRadioButton(const QStyleOption &option, QPainter &painter) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (!(option.state & State_Enabled))
        painter.setOpacity(0.4);
    const QRectF box = middle(option.rect, indicator).adjusted(0.75, 0.75, -0.75, -0.75);
    painter.setPen(QPen(option.state & State_On ? m_tokens.ink : m_tokens.ctl, 1.5));
    painter.setBrush(m_tokens.scene);
    painter.drawEllipse(box);
    if (option.state & State_On) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_tokens.ink);
        painter.drawEllipse(middle(option.rect, 7));
    }
    painter.restore();
}

void SpringstepStyle::drawComboBox(const QStyleOption &option, QPainter &painter) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool hovered = (option.state & State_Enabled) && (option.state & State_MouseOver);
    painter.setPen(m_tokens.line2);
    painter.setBrush(hovered ? m_tokens.hover : m_tokens.scene);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 5.5, 5.5);
    constexpr int arrow = 12;
    const QRect place(option.rect.right() - arrow - 6, option.rect.center().y() - arrow / 2 + 1, arrow,
                      arrow);
    iconOf("down", m_tokens.ink2)
        .paint(&painter, place, Qt::AlignCenter,
               option.state & State_Enabled ? QIcon::Normal : QIcon::Disabled);
    painter.restore();
}

}
