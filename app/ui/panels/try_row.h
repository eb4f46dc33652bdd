#pragma once

#include "app/ui/theme/theme.h"

#include <QCheckBox>
#include <QTextDocument>

namespace app {

/// A thing to try, with a box that the program ticks when it has seen it done.
class TryRow : public QCheckBox
{
    Q_OBJECT

public:
    /// `text`: Markdown.
    TryRow(const QString &text, const Theme &theme, QWidget *parent = nullptr);

    void setDone(bool done);
    /// Says, to those who cannot see it, what is still to do; plain text, which may be empty.
    void setTodo(const QString &todo) { setAccessibleDescription(todo); }
    /// Its text without marks.
    QString plain() const;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void nextCheckState() override;

private:
    void dress();

    const Theme &m_theme;
    QString m_text;
    mutable QTextDocument m_document; ///< laid out for the width last asked for
};

}
