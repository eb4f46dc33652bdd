#pragma once

#include <QPushButton>

namespace app {

/// A button that shortens its text when there is no room, with its icon after the text.
class StepButton : public QPushButton
{
    Q_OBJECT

public:
    explicit StepButton(QWidget *parent = nullptr);

    /// @param brief shown where there is no room for `text`
    void setFullText(const QString &text, const QString &brief);
    /// Highlights the button as the next thing to do.
    void setPrimary(bool primary);
    bool isPrimary() const { return property("primary").toBool(); }
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fit();

    QString m_text;
    QString m_brief;
};

}
