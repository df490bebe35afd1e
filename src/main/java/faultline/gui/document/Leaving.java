package faultline.gui.document;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import java.util.function.Consumer;

/**
 * The questions before something is left that would lose unsaved work: the window, a scenario, or the results of a
 * batch. They are asked again after a file has been written, because the window can be used in that time. A recording
 * or results that the user has chosen to lose are not asked about twice.
 */
public final class Leaving {

    private final Consumer<Leaving> questions;
    private final Set<Object> discarded = Collections.newSetFromMap(new IdentityHashMap<>());

    private Leaving(Consumer<Leaving> questions) {
        this.questions = questions;
    }

    /** Asks questions, the last of which leaves if the user agrees. */
    public static void begin(Consumer<Leaving> questions) {
        new Leaving(questions).ask();
    }

    /** Asks the questions, again if they have been asked. */
    public void ask() {
        questions.accept(this);
    }

    /** Notes that the user has chosen to lose something. */
    public void discard(Object loss) {
        discarded.add(loss);
    }

    /** Returns whether the user has chosen to lose something. */
    public boolean isDiscarded(Object loss) {
        return discarded.contains(loss);
    }
}
