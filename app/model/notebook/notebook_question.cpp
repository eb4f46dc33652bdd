#include "app/model/notebook/notebook_question.h"

#include "app/model/catalog/lists.h"

namespace app {

namespace {

std::optional<NotebookQuestion> recallQuestion(const LessonEntry &lesson, const QString &id)
{
    const lessons::RecallQuestion *one = findById(lesson.recall.questions, id);
    if (!one)
        return std::nullopt;
    return NotebookQuestion{one->text, one->choices, 0, one->task ? &*one->task : nullptr};
}

}

const lessons::RecallChoice *NotebookQuestion::choice(const QString &said) const
{
    bool isNumber = false;
    const uint number = said.toUInt(&isNumber);
    return isNumber && number >= 1 && number <= choices.size() ? &choices[number - 1] : nullptr;
}

std::optional<NotebookQuestion> notebookQuestion(const LessonEntry &lesson, const QString &step,
                                                 const QString &id)
{
    if (step.isEmpty())
        return recallQuestion(lesson, id);
    const lessons::Step *place = lesson.step(step);
    const lessons::Try *one = place ? findById(place->tries, id) : nullptr;
    if (!one || one->choices.isEmpty())
        return std::nullopt;
    NotebookQuestion question{one->text, {}, static_cast<std::size_t>(one->choices.right)};
    for (const QString &choice : one->choices.texts)
        question.choices.push_back({choice, one->answer});
    return question;
}

}
