#pragma once

#include "app/ui/theme/theme.h"

#include <QAbstractButton>
#include <QPointer>

#include <cstdint>

class QLineEdit;

namespace app {

/// "Frame 41 · 2 of 5 phases done". Every digit has the same width, so that numbers do not dance. Click (or Enter)
/// to type a frame to go to.
class FrameCounter : public QAbstractButton
{
    Q_OBJECT

public:
    /// The last frame that can be asked for.
    static constexpr std::int64_t lastFrame = 10'000'000;

    explicit FrameCounter(const Theme &theme, QWidget *parent = nullptr);

    /// `detail` stands after the frame, `brief` in its place where there is little room; both may be empty.
    void show(std::int64_t frame, const QString &detail, const QString &brief);
    /// Whether there is little room.
    void setBrief(bool brief);
    void edit();
    bool isEditing() const { return m_editor != nullptr; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void asked(std::int64_t frame);
    /// What was typed is no frame: a sentence that says what is.
    void refused(const QString &sentence);
    /// The room that it needs is another.
    void resized();

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void take();
    void refuse();
    void leave();
    void placeEditor();
    double captionWidth() const;
    double digitWidth() const;
    double numberWidth() const;
    QString shownDetail() const;

    const Theme &m_theme;
    QString m_number = QStringLiteral("0");
    QString m_detail;
    QString m_brief;
    bool m_isBrief = false;
    QLineEdit *m_editor = nullptr;
    QPointer<QWidget> m_before; ///< what had the focus before the editor
};

}
