#pragma once

#include "app/ui/learn/prose.h"

#include <QAbstractButton>

class QVBoxLayout;

namespace app {

class NarrationText;

/// A button with the question of a why-box, or the title of another box that is folded. A click, Space or Enter unfolds
/// the answer.
class WhyButton : public QAbstractButton
{
    Q_OBJECT

public:
    /// `question` is Markdown.
    WhyButton(const QString &question, const Theme &theme, QWidget *parent = nullptr);

    /// Shows a text in Markdown. text() and the accessible name have it without Markdown syntax.
    void setMarkdown(const QString &text);
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void describeState();
    void applyTheme();

    const Theme &m_theme;
    QString m_markdown;
    mutable QTextDocument m_document; ///< laid out for the width that was last requested
    mutable ProseHeights m_heights;
};

/// A box that is folded to its title until the learner unfolds it.
class FoldBox : public QWidget
{
    Q_OBJECT

public:
    /// `title` is Markdown.
    FoldBox(const QString &title, const Theme &theme, QWidget *parent);

    bool isUnfolded() const { return m_title->isChecked(); }
    void setUnfolded(bool isUnfolded) { m_title->setChecked(isUnfolded); }
    void focusTitle() { m_title->setFocus(Qt::OtherFocusReason); }

signals:
    /// Emitted when the box is folded or unfolded.
    void unfolded(bool open);

protected:
    /// Makes the widgets below the title. Called when the box is first unfolded, because most boxes stay folded and texts
    /// take long to make.
    virtual void fill() = 0;
    bool isFilled() const { return m_isFilled; }
    const Theme &theme() const { return m_theme; }
    WhyButton &title() { return *m_title; }
    /// Shows a title in Markdown, with a tick and with other words for a screen reader if it `isDone`.
    void showTitle(const QString &title, bool isDone, const QString &spoken);
    /// Returns what is below the title, and its layout.
    QWidget *content() const { return m_content; }
    QVBoxLayout &column() const { return *m_column; }
    /// Adds a text in small type.
    NarrationText *addText(const QString &name, const QString &text);

private:
    void fillNow();

    const Theme &m_theme;
    WhyButton *m_title;
    QWidget *m_content;
    QVBoxLayout *m_column;
    bool m_isFilled = false;
};

}
