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
 * @param initial as the session began
 * @param edited as it is by now
 */
record ScenarioDocument(Optional<Path> file, Optional<Scenario> saved, Scenario initial, Scenario edited) {

    /** A document whose session begins. */
    static ScenarioDocument create(Optional<Path> file, Optional<Scenario> saved, Scenario begun) {
        return new ScenarioDocument(file, saved, begun, begun);
    }

    ScenarioDocument withEdited(Scenario newEdited) {
        return new ScenarioDocument(file, saved, initial, newEdited);
    }

    ScenarioDocument withSaved(Optional<Scenario> newSaved) {
        return new ScenarioDocument(file, newSaved, initial, edited);
    }

    ScenarioDocument savedAs(Path newFile, Scenario newSaved) {
        return new ScenarioDocument(Optional.of(newFile), Optional.of(newSaved), initial, edited);
    }

    /** The same in the file of another, as that file holds it. */
    ScenarioDocument withFileOf(ScenarioDocument other) {
        return new ScenarioDocument(other.file, other.saved, initial, edited);
    }

    /** The scenario after what was done to its run. */
    Scenario editedBy(Journal journal) {
        return initial.withSetup(SetupEditor.setupAfter(journal));
    }

    boolean isChanged() {
        return !saved.equals(Optional.of(edited));
    }

    /** What to call it by: its file, or its name where it has none. */
    Path displayPath() {
        return file.orElseGet(() -> Path.of(FileNames.forScenario(initial.name())));
    }
}
