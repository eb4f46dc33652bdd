#pragma once

#include "app/ui/learn/prose.h"

#include <QRadioButton>

namespace app {

/// An answer to choose: a radio button with a text in Markdown that wraps. A click, Space or Enter chooses it, which the
/// signal clicked() tells. The arrow keys go to the next row without choosing it, so that no answer is given by accident.
/// Whoever shows several rows unchecks the others.
class ChoiceRow : public QRadioButton
{
    Q_OBJECT

public:
    /// What is known of an answer that was chosen.
    enum class Verdict { none, right, wrong };

    /// `text` is Markdown, one paragraph.
    ChoiceRow(const QString &text, const Theme &theme, QWidget *parent = nullptr);

    /// Shows a tick or a cross behind the text.
    void setVerdict(Verdict verdict);
    Verdict verdict() const { return m_verdict; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void nextCheckState() override;
    bool hitButton(const QPoint &at) const override;

private:
    void applyTheme();

    const Theme &m_theme;
    QString m_text;
    Verdict m_verdict = Verdict::none;
    mutable QTextDocument m_document; ///< laid out for the width that was last requested
    mutable ProseHeights m_heights;
};

}
