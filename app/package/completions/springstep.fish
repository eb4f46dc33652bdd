# Completion of springstep for fish. Verbs, options and lessons are those that the program itself prints.

function __springstep_steps
    springstep lessons 2>/dev/null | string replace -rf '^ *([a-z0-9_]+/[a-z0-9_]+): (.*)' '$1\t$2'
end

function __springstep_lessons
    springstep lessons 2>/dev/null | string replace -rf '^[0-9]+\. ([a-z0-9_]+): .*' '$1'
end

function __springstep_cases
    springstep lessons 2>/dev/null | string replace -rf '^ *case .*; one of (.*)' '$1' | string split ', '
end

function __springstep_verbs
    springstep --help 2>/dev/null | sed -n '/^Verbs/,/^Options/s/^  \([a-z]\{1,\}\) .*/\1/p'
end

function __springstep_verb_is
    set -l words (commandline -opc)
    test (count $words) -ge 2; and contains -- $words[2] $argv
end

# Prints the options of the verb that was typed, or those of the program.
function __springstep_options
    set -l words (commandline -opc)
    springstep $words[2] --help 2>/dev/null | string replace -rf '^ *(?:-[a-z], )?(--[a-z]+).*' '$1'
end

# Prints folders, and the files whose names end in one of the given ways: json|springstep.
function __springstep_files
    complete -C "__fish_command_without_completions "(commandline -ct) | string match -r -- "^.*(?:/|\.(?:$argv))\$"
end

function __springstep_starts_option
    string match -q -- '-*' (commandline -ct)
end

# Prints the values of the option before the cursor. Fails if there is no option with a value.
function __springstep_values
    set -l words (commandline -opc)
    switch $words[-1]
        case --theme
            string split ' ' 'light dark contrast'
        case --mode
            string split ' ' 'learn measure'
        case --stability
            string split ' ' 'gauge reasons step damping rest'
        case --case
            __springstep_cases
        case --svg
            __springstep_files svg
        case --name --ghost
            return 0 # of a learner, of a run
        case --language
            string split ' ' 'en de es fr'
        case --plot
            string split ' ' 'x y velocity_x velocity_y speed acceleration_x acceleration_y acceleration'
            string split ' ' 'angle spin own_motion distance motion stored energy'
        case --lessons
            __springstep_lessons
        case --tolerance --frames --frame --phase --size --from --to --fps
            return 0 # numbers
        case '*'
            return 1
    end
end

function __springstep_words
    set -l words (commandline -opc)
    __springstep_values; and return
    if __springstep_starts_option
        __springstep_options
    else if test (count $words) -eq 1
        __springstep_verbs
        __springstep_files 'json|springstep'
    else if __springstep_verb_is accuracy cost
        __springstep_steps
        __springstep_files 'json|springstep'
    else if __springstep_verb_is notebook
        if test (count $words) -eq 2
            string split ' ' 'check page write'
        else
            __springstep_files 'springstep-notebook|springstep-lesson|html|pdf'
        end
    else if __springstep_verb_is screenshot
        __springstep_steps
        __springstep_files 'png|jpg'
    else if __springstep_verb_is handout
        __springstep_lessons
        __springstep_files 'springstep-lesson|pdf'
    else if __springstep_verb_is check
        __springstep_files 'springstep-lesson'
    else if __springstep_verb_is trace
        __springstep_files 'json|springstep'
    else if __springstep_verb_is film
        __springstep_files 'json|springstep|webm|gif|html|png'
    end
end

complete -c springstep -f -a '(__springstep_words)'
