# Completion of edgeproof for fish: the program itself proposes words.
complete -c edgeproof -a '(edgeproof --complete (commandline -opc)[2..] (commandline -ct) 2>/dev/null)'
