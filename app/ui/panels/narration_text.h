#pragma once

#include "app/ui/theme/theme.h"

#include <QTextBrowser>

namespace app {

/// A text in Markdown, as high as it needs to be.
class NarrationText : public QTextBrowser
{
    Q_OBJECT

public:
    explicit NarrationText(const Theme &theme, QWidget *parent = nullptr);

    void setText(const QString &markdown);
    /// Larger type, for large windows.
    void setLarge(bool large);
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {120, 20}; }

private:
    void dress();

    const Theme &m_theme;
    QString m_text;
    bool m_large = false;
};

}
