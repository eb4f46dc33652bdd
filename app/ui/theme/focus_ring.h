#pragma once

#include <QObject>
#include <QPointer>

class QFocusFrame;
class QWidget;

namespace app {

/// Returns whether the focus came by keyboard, so that its place is to be shown.
bool isByKeyboard(Qt::FocusReason reason);

/// Draws a ring round the standard control that has the focus. Input fields always get one; other controls
/// get one once the keyboard is used. Widgets that draw their own ring get none.
class FocusRing : public QObject
{
    Q_OBJECT

public:
    static constexpr int gap = 1;
    static constexpr int width = 2;

    explicit FocusRing(QObject *parent = nullptr);
    ~FocusRing() override;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow(QWidget *widget);
    void show();
    void hide();

    QPointer<QWidget> m_widget;
    QPointer<QFocusFrame> m_frame;
};

}
