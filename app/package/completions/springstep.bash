# Completion of springstep for bash. Verbs, options and lessons are those that the program itself prints.

_springstep_steps() {
    springstep lessons 2>/dev/null | sed -n 's|^ *\([a-z0-9_]*/[a-z0-9_]*\): .*|\1|p'
}

_springstep_lessons() {
    springstep lessons 2>/dev/null | sed -n 's|^[0-9]*\. \([a-z0-9_]*\): .*|\1|p'
}

_springstep_cases() {
    springstep lessons 2>/dev/null | sed -n 's/^ *case .*; one of //p' | tr -d ','
}

# Prints the options of a verb, or those of the program.
_springstep_options() {
    springstep "$@" --help 2>/dev/null | sed -n 's/^ *\(-[a-z], \)\{0,1\}\(--[a-z]*\).*/\2/p'
}

_springstep_verbs() {
    springstep --help 2>/dev/null | sed -n '/^Verbs/,/^Options/s/^  \([a-z]\{1,\}\) .*/\1/p'
}

# Offers the words of a list.
_springstep_offer() {
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$cur")
}

# Offers folders, and the files whose names end in one of the given ways: json|springstep.
_springstep_offer_files() {
    local file
    compopt -o filenames 2>/dev/null
    while IFS= read -r file; do
        if [[ -d $file || $file =~ \.($1)$ ]]; then
            COMPREPLY+=("$file")
        fi
    done < <(compgen -f -- "$cur")
}

# Offers the values of an option. Fails if the word before the cursor is no option with a value.
_springstep_offer_value() {
    case $1 in
        --theme) _springstep_offer "light dark contrast" ;;
        --mode) _springstep_offer "learn measure" ;;
        --stability) _springstep_offer "gauge reasons step damping rest" ;;
        --case) _springstep_offer "$(_springstep_cases)" ;;
        --svg) _springstep_offer_files svg ;;
        --name | --ghost) ;; # of a learner, of a run
        --language) _springstep_offer "en de es fr" ;;
        --plot)
            _springstep_offer "x y velocity_x velocity_y speed acceleration_x acceleration_y acceleration"
            _springstep_offer "angle spin own_motion distance motion stored energy"
            ;;
        --lessons) _springstep_offer "$(_springstep_lessons)" ;;
        --tolerance | --frames | --frame | --phase | --size | --from | --to | --fps) ;; # numbers
        *) return 1 ;;
    esac
}

_springstep() {
    local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]}
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        if [[ $cur == -* ]]; then
            _springstep_offer "$(_springstep_options)"
        else
            _springstep_offer "$(_springstep_verbs)"
            _springstep_offer_files 'json|springstep'
        fi
        return
    fi
    _springstep_offer_value "$previous" && return
    if [[ $cur == -* ]]; then
        _springstep_offer "$(_springstep_options "$verb")"
        return
    fi
    case $verb in
        check) _springstep_offer_files 'springstep-lesson' ;;
        trace) _springstep_offer_files 'json|springstep' ;;
        film) _springstep_offer_files 'json|springstep|webm|gif|html|png' ;;
        notebook)
            if ((COMP_CWORD == 2)); then
                _springstep_offer "check page write"
            else
                _springstep_offer_files 'springstep-notebook|springstep-lesson|html|pdf'
            fi
            ;;
        handout)
            _springstep_offer "$(_springstep_lessons)"
            _springstep_offer_files 'springstep-lesson|pdf'
            ;;
        accuracy | cost)
            _springstep_offer "$(_springstep_steps)"
            _springstep_offer_files 'json|springstep'
            ;;
        screenshot)
            _springstep_offer "$(_springstep_steps)"
            _springstep_offer_files 'png|jpg'
            ;;
    esac
}

complete -F _springstep springstep
