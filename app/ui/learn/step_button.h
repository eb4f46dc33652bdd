#pragma once

#include <QPushButton>

namespace app {

class Theme;

/// A button that shortens its text when there is no room, with its icon after the text.
class StepButton : public QPushButton
{
    Q_OBJECT

public:
    explicit StepButton(QWidget *parent = nullptr);

    /// @param brief shown where there is no room for `text`
    void setFullText(const QString &text, const QString &brief);
    /// Shows an arrow in the colours of `theme`, which must outlive the button, while the button is enabled.
    void showArrow(const Theme &theme);
    /// Highlights the button as the next thing to do.
    void setPrimary(bool primary);
    bool isPrimary() const { return property("primary").toBool(); }
    QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();
    void drawArrow();

    const Theme *m_theme = nullptr; ///< of the arrow; null: there is none
    QString m_text;
    QString m_brief;
};

}
