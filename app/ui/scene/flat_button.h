#pragma once

#include "app/ui/theme/theme.h"

#include <QToolButton>

namespace app {

/// A flat toolbar button with a caption, an emphasised value, and an arrow if it opens a menu.
class FlatButton : public QToolButton
{
    Q_OBJECT

public:
    FlatButton(const Theme &theme, QWidget *parent = nullptr);

    /// Sets the texts: `caption` is pale, `value` is emphasised. Either may be empty.
    void setTexts(const QString &caption, const QString &value);
    /// Sets an icon of the theme, shown before the texts.
    void setIconName(const QString &name);
    /// Hides the caption if space is short.
    void setShort(bool isShort);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    /// Returns the width with the caption, px.
    int fullWidth() const;
    /// Returns the width without the caption if the button has a value, px.
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
