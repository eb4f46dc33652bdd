#pragma once

#include "app/ui/theme/theme.h"

#include <QAbstractButton>
#include <QPointer>

#include <cstdint>

class QLineEdit;

namespace app {

/// A label with the frame: "Frame 41 · 2 of 5 phases done". Every digit has the same width, so that the text does not
/// jitter. A click or Enter turns it into a field for a frame to go to.
class FrameCounter : public QAbstractButton
{
    Q_OBJECT

public:
    /// The last frame that a learner can go to.
    static constexpr std::int64_t lastFrame = 10'000'000;

    explicit FrameCounter(const Theme &theme, QWidget *parent = nullptr);

    /// Shows a frame with `detail` after it, or with `brief` if space is short. Both may be empty.
    void show(std::int64_t frame, const QString &detail, const QString &brief);
    /// Sets whether space is short.
    void setBrief(bool brief);
    void edit();
    bool isEditing() const { return m_editor != nullptr; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void frameRequested(std::int64_t frame);
    /// The typed text is not a frame. `sentence` says what is.
    void refused(const QString &sentence);
    /// sizeHint() has changed.
    void resized();

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void take();
    void refuse();
    void leave();
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
    QPointer<QWidget> m_before; ///< had the focus before the editor
};

}
