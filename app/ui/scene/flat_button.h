#pragma once

#include "app/ui/theme/theme.h"

#include <QToolButton>

namespace app {

/// A flat button of a bar: a caption, a value that stands out, and an arrow when it opens a menu.
class FlatButton : public QToolButton
{
    Q_OBJECT

public:
    FlatButton(const Theme &theme, QWidget *parent = nullptr);

    /// `caption` is pale, `value` stands out; either may be empty.
    void setTexts(const QString &caption, const QString &value);
    /// An icon of the theme, before the texts.
    void setIconName(const QString &name);
    /// Without its caption, where room is short.
    void setShort(bool isShort);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    /// How wide it is with its caption.
    int fullWidth() const;
    /// How wide it is without, if it has a value.
    int shortWidth() const;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    int widthWith(const QString &caption) const;

    const Theme &m_theme;
    QString m_caption;
    QString m_value;
    QString m_icon;
    bool m_short = false;
};

}
