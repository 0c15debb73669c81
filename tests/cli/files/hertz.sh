# Answers the questions of three.toml; a wedge, of which it knows nothing, ends it.
while read -r row; do
    case $row in
    *phi* | w:*) exit 3 ;;
    id,*) echo id,value ;;
    *u=0.25*) echo h:right:u=0.25:p,0.3307189138830738 ;;
    *u=0.5*) echo h:right:u=0.5:p,0.4330127018922193 ;;
    *u=1:*) echo h:right:u=1:p,0.5 ;;
    esac
done
