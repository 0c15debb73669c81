# Completion of edgeproof for bash: the program itself proposes words.
_edgeproof() {
    COMPREPLY=($(edgeproof --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null))
}
complete -o bashdefault -o default -F _edgeproof edgeproof
