package faultline.gui.document;

import faultline.engine.Journal;
import faultline.scenario.Scenario;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A scenario that is being edited, and what its file holds of it.
 *
 * @param file where it is kept, empty for one that ships with the program
 * @param saved as the file holds it, empty where no file holds it
 * @param begun as the session began
 * @param edited as it is by now
 */
record Document(Optional<Path> file, Optional<Scenario> saved, Scenario begun, Scenario edited) {

    /** A document whose session begins. */
    static Document begin(Optional<Path> file, Optional<Scenario> saved, Scenario begun) {
        return new Document(file, saved, begun, begun);
    }

    Document withEdited(Scenario newEdited) {
        return new Document(file, saved, begun, newEdited);
    }

    Document withSaved(Optional<Scenario> newSaved) {
        return new Document(file, newSaved, begun, edited);
    }

    Document savedAs(Path newFile, Scenario newSaved) {
        return new Document(Optional.of(newFile), Optional.of(newSaved), begun, edited);
    }

    /** The same in the file of another, as that file holds it. */
    Document filedAs(Document other) {
        return new Document(other.file, other.saved, begun, edited);
    }

    /** The scenario after what was done to its run. */
    Scenario after(Journal journal) {
        return begun.withSetup(EditedSetup.of(journal));
    }

    boolean isChanged() {
        return !saved.equals(Optional.of(edited));
    }

    /** What to call it by: its file, or its name where it has none. */
    Path name() {
        return file.orElseGet(() -> Path.of(FileName.of(begun.name())));
    }
}
