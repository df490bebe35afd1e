package faultline.gui.edit;

import java.util.ArrayList;
import java.util.List;

/** When edits were done, undone and redone, so that what can be undone and redone follows the run to other moments of its time. */
final class Chronicle {

    private final EditHistory history;
    private final List<Moment> moments = new ArrayList<>();
    /** How many of the moments the run has behind it. */
    private int reached;

    /** An edit was done, or undone, at the start of a tick. */
    private record Moment(long tick, CommandEdit edit, boolean done) {
    }

    Chronicle(EditHistory history) {
        this.history = history;
    }

    /** An edit is done or undone now; nothing is ahead any more. */
    void add(long tick, CommandEdit edit, boolean done) {
        moments.add(new Moment(tick, edit, done));
        reached = moments.size();
    }

    /** The tick in which an edit was first done; 0 where it was there before the run began. */
    long begun(CommandEdit edit) {
        return moments.stream().filter(moment -> moment.edit() == edit).mapToLong(Moment::tick).findFirst().orElse(0);
    }

    /** Something is done now: what was ahead will not happen. Says whether anything was. */
    boolean fork() {
        boolean ahead = reached < moments.size();
        moments.subList(reached, moments.size()).clear();
        return ahead;
    }

    /** The run stands after a tick, and what was done later is ahead. Says whether that changes anything. */
    boolean goTo(long tick) {
        int before = reached;
        while (reached > 0 && moments.get(reached - 1).tick() > tick) {
            reached--;
            goBackOver(moments.get(reached));
        }
        return goOn(tick) || reached != before;
    }

    /** The run has come past a tick. Says whether that changes anything. */
    boolean goOn(long tick) {
        int before = reached;
        while (reached < moments.size() && moments.get(reached).tick() <= tick) {
            pass(moments.get(reached));
            reached++;
        }
        return reached != before;
    }

    private void goBackOver(Moment moment) {
        if (moment.done()) {
            history.undoQuietly(moment.edit(), true);
        } else {
            history.redoQuietly(moment.edit());
        }
    }

    private void pass(Moment moment) {
        if (moment.done()) {
            history.redoQuietly(moment.edit());
        } else {
            history.undoQuietly(moment.edit(), false);
        }
    }

    /** The run begins anew with all that was done, also what is ahead; from now on that has always been so. */
    void beginAnew() {
        goOn(Long.MAX_VALUE);
        clear();
    }

    void clear() {
        moments.clear();
        reached = 0;
    }
}
