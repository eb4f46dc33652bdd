#pragma once

#include "app/ui/theme/theme.h"

#include <QProxyStyle>

#include <memory>

namespace app {

class FocusRing;

/// A style for details that a style sheet cannot express: the focus ring, check marks, combo boxes, and
/// sliders that jump to a click.
class SpringstepStyle : public QProxyStyle
{
    Q_OBJECT

public:
    explicit SpringstepStyle(Tokens tokens);
    ~SpringstepStyle() override;

    void polish(QApplication *application) override;
    void unpolish(QApplication *application) override;
    using QProxyStyle::polish;
    using QProxyStyle::unpolish;

    int pixelMetric(PixelMetric metric, const QStyleOption *option = nullptr,
                    const QWidget *widget = nullptr) const override;
    int styleHint(StyleHint hint, const QStyleOption *option = nullptr, const QWidget *widget = nullptr,
                  QStyleHintReturn *returned = nullptr) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget = nullptr) const override;
    void drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget = nullptr) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                            const QWidget *widget = nullptr) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                           const QWidget *widget = nullptr) const override;

private:
    void drawCheckBox(const QStyleOption &option, QPainter &painter) const;
    void drawRadioButton(const QStyleOption &option, QPainter &painter) const;
    void drawComboBox(const QStyleOption &option, QPainter &painter) const;

    Tokens m_tokens;
    std::unique_ptr<FocusRing> m_ring;
};

}
