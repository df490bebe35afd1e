package faultline.gui.window;

import static faultline.gui.action.Keystrokes.menu;
import static faultline.gui.action.Keystrokes.menuShift;

import faultline.gui.action.UiAction;
import faultline.gui.document.Bench;
import faultline.gui.document.FileName;
import faultline.gui.document.Filing;
import faultline.gui.document.Recovery;
import faultline.gui.document.Rescuer;
import faultline.gui.text.Texts;
import faultline.gui.theme.Glyph;
import faultline.scenario.Scenario;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Opening and saving, with the questions that go with it. */
final class FileDesk {

    private final Component parent;
    private final Bench bench;
    private final Filing filing;
    private final FileQuestions questions;
    private final BooleanSupplier settle;

    /** For a bench; {@code settle} takes what is being typed, and says whether that changed anything. */
    FileDesk(Component parent, Bench bench, BooleanSupplier settle) {
        this.parent = parent;
        this.bench = bench;
        this.filing = new Filing(bench);
        this.settle = settle;
        this.questions = new FileQuestions(parent);
    }

    void addTo(UiActions actions, Runnable quit) {
        actions.add(UiAction.of("open", this::open).on(menu(KeyEvent.VK_O)).drawn(Glyph.OPEN));
        actions.add(UiAction.of("revert", this::revert));
        actions.add(UiAction.of("save", this::save).on(menu(KeyEvent.VK_S)).drawn(Glyph.SAVE));
        actions.add(UiAction.of("saveAs", () -> saveAs(FileDesk::nothing)).on(menuShift(KeyEvent.VK_S)));
        actions.add(UiAction.of("saveJournal", this::saveJournal));
        actions.add(UiAction.of("quit", quit).on(menu(KeyEvent.VK_Q)));
    }

    private static void nothing() {
    }

    private void open() {
        unlessLost(() -> questions.fileToOpen("open", bench.file()).ifPresent(filing::open));
    }

    /** Asks which run to show beside this one. */
    Optional<Path> fileForGhost() {
        return questions.fileToOpen("openGhost", bench.file());
    }

    /** Opens a file, whatever is lost. */
    void openAtOnce(Path file) {
        filing.open(file);
    }

    /** Opens a scenario that ships with the program, whatever is lost. */
    void openShippedAtOnce(String name) {
        filing.openShipped(name);
    }

    /** Opens a file that was dropped on the window. */
    void open(Path file) {
        unlessLost(() -> filing.open(file));
    }

    /** Opens a scenario that ships with the program. */
    void openShipped(String name) {
        unlessLost(() -> filing.openShipped(name));
    }

    private void revert() {
        if (bench.isChanged() && questions.choose("revert", Texts.text("revert.question"), "revert.revert", "unsaved.cancel") == 0) {
            filing.revert();
        }
    }

    /** Somebody else has changed the open file: it is read again only if the user wants it. */
    void changedOnDisk(Path file) {
        String name = String.valueOf(file.getFileName());
        boolean reload = bench.isChanged() ? questions.choose("changed", Texts.text("changed.questionUnsaved", name), "changed.keep",
                "changed.reload") == 1
                : questions.choose("changed", Texts.text("changed.question", name), "changed.reload", "changed.keep") == 0;
        if (reload) {
            filing.open(file);
        }
    }

    /** Offers what a crash has left; a user who only closes the question is asked again at the next start. */
    Rescuer.Answer offer(Recovery.Rescue rescue) {
        String name = rescue.origin().map(file -> String.valueOf(file.getFileName())).orElse(rescue.scenario().name());
        int answer = questions.choose("recover", Texts.text("recover.question", name), "recover.recover", "recover.discard");
        if (answer == 0) {
            filing.recover(rescue);
            return Rescuer.Answer.RECOVER;
        }
        return answer == 1 ? Rescuer.Answer.DISCARD : Rescuer.Answer.LATER;
    }

    private void save() {
        settle.getAsBoolean();
        save(FileDesk::nothing);
    }

    private void save(Runnable then) {
        bench.file().ifPresentOrElse(file -> filing.save(file, then), () -> saveAs(then));
    }

    private void saveAs(Runnable then) {
        questions.fileToSave("saveAs", suggestion(".xml")).ifPresent(file -> filing.save(file, then));
    }

    private void saveJournal() {
        questions.fileToSave("saveJournal", suggestion("-journal.xml")).ifPresent(filing::saveJournal);
    }

    /** Asks which file of another kind to write; its name is suggested after the open file's. */
    Optional<Path> fileFor(String action, String extension) {
        return questions.fileToSave(action, suggestion(extension));
    }

    /** The name of the open file, or of the scenario, with something behind it. */
    private Path suggestion(String ending) {
        String scenario = FileName.of(bench.scenario().map(Scenario::name).orElse(""));
        Path file = bench.file().orElse(Path.of(scenario + ".xml"));
        String name = file.getFileName().toString().replaceFirst("\\.xml$", "");
        return file.resolveSibling(name + ending);
    }

    /** Does something that would lose unsaved changes, after asking what is to become of them. */
    void unlessLost(Runnable deed) {
        // What is taken only now is on its way to the run, and no change yet.
        boolean changed = settle.getAsBoolean() || bench.isChanged();
        if (!changed) {
            deed.run();
            return;
        }
        int answer = questions.choose("unsaved", Texts.text("unsaved.question"), "unsaved.save", "unsaved.discard", "unsaved.cancel");
        if (answer == 0) {
            save(deed);
        } else if (answer == 1) {
            deed.run();
        }
    }

    /** The name of what is open, for the window's title. */
    String title() {
        Optional<String> name = bench.file().map(file -> file.getFileName().toString());
        String shown = name.or(() -> bench.scenario().map(Scenario::name)).orElse(Texts.text("title.none"));
        String kind = bench.scenario().filter(Scenario::recorded).map(run -> " " + Texts.text("title.replay")).orElse("");
        return shown + (bench.isChanged() ? "*" : "") + kind + " – Faultline";
    }
}
