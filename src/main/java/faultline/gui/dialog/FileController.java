package faultline.gui.dialog;

import static faultline.gui.action.Keystrokes.menuShiftShortcut;
import static faultline.gui.action.Keystrokes.menuShortcut;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.UiAction;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.FileNames;
import faultline.gui.document.RecoveryPrompt;
import faultline.gui.document.RecoveryStore;
import faultline.gui.document.Workspace;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.scenario.Scenario;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Opening and saving, with the questions that go with it. */
public final class FileController {

    private final Component parent;
    private final Workspace workspace;
    private final DocumentStore documentStore;
    private final FileDialogs fileDialogs;
    private final BooleanSupplier commitPendingEdit;

    /** For a bench; {@code settle} takes what is being typed, and says whether that changed anything. */
    public FileController(Component parent, Workspace bench, BooleanSupplier settle) {
        this.parent = parent;
        this.workspace = bench;
        this.documentStore = new DocumentStore(bench);
        this.commitPendingEdit = settle;
        this.fileDialogs = new FileDialogs(parent);
    }

    public void addTo(ActionRegistry actions, Runnable quit) {
        actions.add(UiAction.of("open", this::open)
                .withAccelerator(menuShortcut(KeyEvent.VK_O))
                .withIcon(Glyph.OPEN));
        actions.add(UiAction.of("revert", this::revert));
        actions.add(UiAction.of("save", this::save)
                .withAccelerator(menuShortcut(KeyEvent.VK_S))
                .withIcon(Glyph.SAVE));
        actions.add(UiAction.of("saveAs", () -> saveAs(FileController::doNothing))
                .withAccelerator(menuShiftShortcut(KeyEvent.VK_S)));
        actions.add(UiAction.of("saveJournal", this::saveJournal));
        actions.add(UiAction.of("quit", quit).withAccelerator(menuShortcut(KeyEvent.VK_Q)));
    }

    private static void doNothing() {}

    private void open() {
        runIfChangesHandled(
                () -> fileDialogs.chooseFileToOpen("open", workspace.file()).ifPresent(documentStore::open));
    }

    /** Asks which run to show beside this one. */
    public Optional<Path> chooseReferenceRunFile() {
        return fileDialogs.chooseFileToOpen("openGhost", workspace.file());
    }

    /** Opens a file, whatever is lost. */
    public void openWithoutAsking(Path file) {
        documentStore.open(file);
    }

    /** Opens a scenario that ships with the program, whatever is lost. */
    public void openShippedWithoutAsking(String name) {
        documentStore.openShipped(name);
    }

    /** Opens a file that was dropped on the window. */
    public void open(Path file) {
        runIfChangesHandled(() -> documentStore.open(file));
    }

    /** Opens a scenario that ships with the program. */
    public void openShipped(String name) {
        runIfChangesHandled(() -> documentStore.openShipped(name));
    }

    private void revert() {
        if (workspace.isChanged()
                && fileDialogs.showOptions("revert", Messages.get("revert.question"), "revert.revert", "unsaved.cancel")
                        == 0) {
            documentStore.revert();
        }
    }

    /** Somebody else has changed the open file: it is read again only if the user wants it. */
    public void onFileChangedOnDisk(Path file) {
        String name = String.valueOf(file.getFileName());
        boolean reload = workspace.isChanged()
                ? fileDialogs.showOptions(
                                "changed",
                                Messages.get("changed.questionUnsaved", name),
                                "changed.keep",
                                "changed.reload")
                        == 1
                : fileDialogs.showOptions(
                                "changed", Messages.get("changed.question", name), "changed.reload", "changed.keep")
                        == 0;
        if (reload) {
            documentStore.open(file);
        }
    }

    /** Offers what a crash has left; a user who only closes the question is asked again at the next start. */
    public RecoveryPrompt.Answer offerRecovery(RecoveryStore.RecoveredFile rescue) {
        String name = rescue.origin()
                .map(file -> String.valueOf(file.getFileName()))
                .orElse(rescue.scenario().name());
        int answer = fileDialogs.showOptions(
                "recover", Messages.get("recover.question", name), "recover.recover", "recover.discard");
        if (answer == 0) {
            documentStore.recover(rescue);
            return RecoveryPrompt.Answer.RECOVER;
        }
        return answer == 1 ? RecoveryPrompt.Answer.DISCARD : RecoveryPrompt.Answer.LATER;
    }

    private void save() {
        commitPendingEdit.getAsBoolean();
        save(FileController::doNothing);
    }

    private void save(Runnable then) {
        workspace.file().ifPresentOrElse(file -> documentStore.save(file, then), () -> saveAs(then));
    }

    private void saveAs(Runnable then) {
        fileDialogs.chooseFileToSave("saveAs", suggestedFile(".xml")).ifPresent(file -> documentStore.save(file, then));
    }

    private void saveJournal() {
        fileDialogs
                .chooseFileToSave("saveJournal", suggestedFile("-journal.xml"))
                .ifPresent(documentStore::saveJournal);
    }

    /** Asks which file of another kind to write; its name is suggested after the open file's. */
    public Optional<Path> chooseExportFile(String action, String extension) {
        return fileDialogs.chooseFileToSave(action, suggestedFile(extension));
    }

    /** The name of the open file, or of the scenario, with something behind it. */
    private Path suggestedFile(String ending) {
        String scenario =
                FileNames.forScenario(workspace.scenario().map(Scenario::name).orElse(""));
        Path file = workspace.file().orElse(Path.of(scenario + ".xml"));
        String name = file.getFileName().toString().replaceFirst("\\.xml$", "");
        return file.resolveSibling(name + ending);
    }

    /** Does something that would lose unsaved changes, after asking what is to become of them. */
    public void runIfChangesHandled(Runnable deed) {
        // What is taken only now is on its way to the run, and no change yet.
        boolean changed = commitPendingEdit.getAsBoolean() || workspace.isChanged();
        if (!changed) {
            deed.run();
            return;
        }
        int answer = fileDialogs.showOptions(
                "unsaved", Messages.get("unsaved.question"), "unsaved.save", "unsaved.discard", "unsaved.cancel");
        if (answer == 0) {
            save(deed);
        } else if (answer == 1) {
            deed.run();
        }
    }

    /** The name of what is open, for the window's title. */
    public String documentTitle() {
        Optional<String> name = workspace.file().map(file -> file.getFileName().toString());
        String shown = name.or(() -> workspace.scenario().map(Scenario::name)).orElse(Messages.get("title.none"));
        String kind = workspace
                .scenario()
                .filter(Scenario::recorded)
                .map(run -> " " + Messages.get("title.replay"))
                .orElse("");
        return shown + (workspace.isChanged() ? "*" : "") + kind + " – Faultline";
    }
}
