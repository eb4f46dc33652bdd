#pragma once

#include "app/ui/learn/prose.h"

#include <QCheckBox>

namespace app {

/// A task with a check box that the program ticks when it has seen the learner do it.
class TryRow : public QCheckBox
{
    Q_OBJECT

public:
    /// `text` is Markdown.
    TryRow(const QString &text, const Theme &theme, QWidget *parent = nullptr);

    void setDone(bool done);
    /// Tells screen readers what is still to do, as plain text, which may be empty.
    void setTodo(const QString &todo) { setAccessibleDescription(todo); }
    /// Returns the text without Markdown syntax.
    QString plain() const;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void nextCheckState() override;

private:
    void applyTheme();

    const Theme &m_theme;
    QString m_text;
    mutable QTextDocument m_document; ///< laid out for the width that was last requested
    mutable ProseHeights m_heights;
};

}
