package faultline.gui.dialog;

import static faultline.gui.action.Keystrokes.menuShiftShortcut;
import static faultline.gui.action.Keystrokes.menuShortcut;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.UiAction;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.FileNames;
import faultline.gui.document.Leaving;
import faultline.gui.document.RecoveryPrompt;
import faultline.gui.document.RecoveryStore;
import faultline.gui.document.TaskKind;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceTask;
import faultline.gui.properties.FloorPlanFiles;
import faultline.gui.properties.ImportForm;
import faultline.gui.text.Messages;
import faultline.gui.text.TextDirection;
import faultline.gui.theme.Glyph;
import faultline.scenario.Scenario;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Opens and saves files, and asks the questions that this requires. */
public final class FileController {

    private final Workspace workspace;
    private final DocumentStore documentStore;
    private final Component parent;
    private final FileDialogs fileDialogs;
    private final BooleanSupplier commitPendingEdit;
    /** The file that was opened last without a question, such as that of the command line; null if none was. */
    private Path requestedFile;

    private BiConsumer<Leaving, Runnable> leaveQuestion = (leaving, action) -> action.run();

    /**
     * Creates a controller for a workspace. {@code commitPendingEdit} commits what is being typed and returns whether
     * that changed a value.
     */
    public FileController(Component parent, Workspace workspace, BooleanSupplier commitPendingEdit) {
        this(parent, workspace, commitPendingEdit, new FileDialogs(parent));
    }

    FileController(Component parent, Workspace workspace, BooleanSupplier commitPendingEdit, FileDialogs fileDialogs) {
        this.workspace = workspace;
        this.documentStore = new DocumentStore(workspace);
        this.commitPendingEdit = commitPendingEdit;
        this.parent = parent;
        this.fileDialogs = fileDialogs;
    }

    public void addTo(ActionRegistry actions, Runnable quit) {
        actions.add(UiAction.of("open", this::open)
                .withAccelerator(menuShortcut(KeyEvent.VK_O))
                .withIcon(Glyph.OPEN));
        actions.add(UiAction.of(
                "importPlan",
                () -> runIfChangesHandled(() -> fileDialogs
                        .chooseFloorPlan()
                        .flatMap(plan -> ImportForm.showDialog(parent, plan))
                        .ifPresent(documentStore::create))));
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
        runIfChangesHandled(() -> fileDialogs
                .chooseFileToOpen("open", workspace.file().orElse(null))
                .ifPresent(documentStore::open));
    }

    /** Asks for the reference run to load. */
    public Optional<Path> chooseReferenceRunFile() {
        return fileDialogs.chooseFileToOpen("openGhost", workspace.file().orElse(null));
    }

    /** Opens a file and discards unsaved changes. */
    public void openWithoutAsking(Path file) {
        requestedFile = file;
        documentStore.open(file);
    }

    /** Opens a file with a given reader, and discards unsaved changes. */
    public void openWithoutAsking(Path file, Callable<Scenario> reader) {
        requestedFile = file;
        documentStore.open(file, reader);
    }

    /** Opens a shipped scenario and discards unsaved changes. */
    public void openShippedWithoutAsking(String name) {
        documentStore.openShipped(name);
    }

    /**
     * Opens the first of some files, or imports it if it is a floor plan; {@code note} receives that the others are not
     * opened.
     */
    public void openFirst(List<Path> files, Consumer<String> note) {
        Path first = files.get(0);
        Runnable then = () -> noteOthers("note.firstOpened", files, note);
        Runnable otherwise = () -> noteOthers("note.firstNotOpened", files, note);
        runIfChangesHandled(() -> {
            if (FloorPlanFiles.isFloorPlan(first)) {
                ImportForm.showDialog(parent, first)
                        .ifPresentOrElse(scenario -> documentStore.create(scenario, then, otherwise), otherwise);
            } else {
                documentStore.open(first, then, otherwise);
            }
        });
    }

    private static void noteOthers(String key, List<Path> files, Consumer<String> note) {
        if (files.size() > 1) {
            note.accept(Messages.get(key, FileNames.lastOf(files.get(0)), Integer.toString(files.size() - 1)));
        }
    }

    /**
     * Creates what opens the first of the files that are dropped on a window, after a runnable; {@code note} receives
     * what is not opened.
     */
    public TransferHandler createDropHandler(Runnable before, Consumer<String> note) {
        return new FileDropHandler(
                files -> {
                    before.run();
                    openFirst(files, note);
                },
                note);
    }

    /** Opens a scenario that is part of the program. */
    public void openShipped(String name) {
        runIfChangesHandled(() -> documentStore.openShipped(name));
    }

    /** Opens a new scenario and discards unsaved changes. */
    public void openNewWithoutAsking(Scenario scenario) {
        documentStore.create(scenario);
    }

    /**
     * Opens a generated scenario, which does not count as unsaved; discards unsaved changes. {@code then} runs when it
     * is open.
     */
    public void openGeneratedWithoutAsking(Scenario scenario, Runnable then) {
        documentStore.openGenerated(scenario, then);
    }

    /**
     * Returns the open scenario with all edits, the number being typed included; empty if none is open. The future
     * completes on the event dispatch thread.
     */
    public Optional<CompletableFuture<Scenario>> editedScenario() {
        // A number that cannot be applied does not count.
        boolean ignored = commitPendingEdit.getAsBoolean();
        return documentStore.editedScenario();
    }

    /**
     * Returns what opens the scenario that is open now again, with its file and the edits that it is given, after
     * another one has been opened. It asks about unsaved changes of that one first.
     */
    public Consumer<Scenario> reopening() {
        Path file = workspace.file().orElse(null);
        Scenario base = workspace.replaceableScenario().orElse(null);
        return edited -> runIfChangesHandled(() -> documentStore.openEdited(file, base, edited));
    }

    private void revert() {
        if (workspace.isChanged()
                && fileDialogs.showOptions("revert", Messages.get("revert.question"), "revert.revert", "unsaved.cancel")
                        == 0) {
            runIfRecordingHandled(documentStore::revert);
        }
    }

    /** Asks whether to discard a recording rather than save it; empty if the question is cancelled or closed. */
    public Optional<Boolean> askToDiscardRecording() {
        int answer = fileDialogs.showOptions(
                "recording",
                Messages.get("recording.question"),
                "recording.save",
                "recording.discard",
                "unsaved.cancel");
        return switch (answer) {
            case 0 -> Optional.of(false);
            case 1 -> Optional.of(true);
            default -> Optional.empty();
        };
    }

    /** Sets what runs an action that leaves the scenario after a question of its own, or does not run it. */
    public void setLeaveQuestion(BiConsumer<Leaving, Runnable> newQuestion) {
        leaveQuestion = newQuestion;
    }

    private void runIfRecordingHandled(Runnable action) {
        Leaving.begin(leaving -> leaveQuestion.accept(leaving, action));
    }

    /**
     * Asks whether to reload the open file after another program has changed it. Returns true if the user keeps the
     * open scenario, and false if the file is reloaded or the question is closed.
     */
    public boolean onFileChangedOnDisk(Path file) {
        String name = FileNames.lastOf(file);
        boolean changed = workspace.isChanged();
        int answer = changed
                ? fileDialogs.showOptions(
                        "changed", Messages.get("changed.questionUnsaved", name), "changed.keep", "changed.reload")
                : fileDialogs.showOptions(
                        "changed", Messages.get("changed.question", name), "changed.reload", "changed.keep");
        int keep = changed ? 0 : 1;
        if (answer == 1 - keep) {
            reload(file);
        }
        return answer == keep;
    }

    /**
     * Offers to recover edits after a crash, and opens them on request. If the user decides later or closes the
     * question, or the edits cannot be opened, they are offered again at the next start.
     */
    public void offerRecovery(RecoveryStore.RecoveredFile recovered, Consumer<RecoveryPrompt.Answer> onAnswer) {
        int answer = fileDialogs.showOptions(
                "recover",
                RecoveryQuestion.text(recovered, shownFile().orElse(null)),
                "recover.recover",
                "recover.discard",
                "recover.later");
        if (answer == 0) {
            documentStore.recover(
                    recovered,
                    () -> onAnswer.accept(RecoveryPrompt.Answer.RECOVER),
                    () -> onAnswer.accept(RecoveryPrompt.Answer.NOT_OPENED));
        } else {
            onAnswer.accept(answer == 1 ? RecoveryPrompt.Answer.DISCARD : RecoveryPrompt.Answer.LATER);
        }
    }

    /** Returns the file that the window shows or is asked to open. */
    private Optional<Path> shownFile() {
        return workspace
                .task()
                .filter(task -> task.kind() == TaskKind.OPEN && task.name().equals(requestedFile))
                .map(WorkspaceTask::name)
                .or(workspace::file);
    }

    private void save() {
        // A number that cannot be applied does not prevent the save.
        boolean ignored = commitPendingEdit.getAsBoolean();
        save(FileController::doNothing);
    }

    private void save(Runnable then) {
        if (workspace.file().isPresent()) {
            documentStore.saveUnlessReplaced(then, this::askBeforeSaving);
        } else {
            saveAs(then);
        }
    }

    /** Asks whether to save over the change of another program; nothing happens if the question is closed. */
    private void askBeforeSaving(DocumentStore.ForeignChange change) {
        boolean readable = change.problem() == null;
        int answer = readable
                ? fileDialogs.showOptions(
                        "changed",
                        Messages.get("changed.questionUnsaved", FileNames.lastOf(change.file())),
                        "changed.keep",
                        "changed.reload")
                : fileDialogs.showOptions(
                        "changed",
                        Messages.get("changed.questionBroken", Dialogs.unreadableFileText(change.problem())),
                        "changed.replace",
                        "unsaved.cancel");
        if (answer == 0) {
            change.save().run();
        } else if (answer == 1 && readable) {
            reload(change.file());
        }
    }

    private void reload(Path file) {
        runIfRecordingHandled(() -> documentStore.open(file));
    }

    private void saveAs(Runnable then) {
        fileDialogs
                .chooseFileToSave("saveAs", suggestedScenarioFile())
                .ifPresent(file -> documentStore.save(file, then));
    }

    private void saveJournal() {
        fileDialogs
                .chooseFileToSave("saveJournal", suggestedFile("-journal" + FileNames.newScenarioEnding()))
                .ifPresent(documentStore::saveJournal);
    }

    /** Asks for an export file; its suggested name follows that of the open file. */
    public Optional<Path> chooseExportFile(String action, String extension) {
        return chooseFile(action, suggestedFile(extension));
    }

    /** Asks for a file to write, of the same type as the suggestion; empty if cancelled. */
    public Optional<Path> chooseFile(String action, Path suggestion) {
        return fileDialogs.chooseFileToSave(action, suggestion);
    }

    /** Asks for a folder that is empty or does not exist yet, given a suggestion; empty if cancelled. */
    public Optional<Path> chooseNewFolder(String action, Path suggestion) {
        return fileDialogs.chooseNewFolder(action, suggestion);
    }

    /** Asks for a folder of results or one of its tables; empty if cancelled. */
    public Optional<Path> chooseResults(String action) {
        return fileDialogs.chooseFolderOrFile(action, "csv", "json");
    }

    /** Returns the open file with its folder, also if the command line names it without one; empty if there is none. */
    private Optional<Path> openFile() {
        return workspace.file().map(Path::toAbsolutePath);
    }

    /** Returns the open file if its extension is one of scenario files, or else a name with that of new ones. */
    Path suggestedScenarioFile() {
        return openFile()
                .filter(file ->
                        FileNames.hasScenarioExtension(file.getFileName().toString()))
                .orElseGet(() -> suggestedFile(FileNames.newScenarioEnding()));
    }

    /** Returns the name of the open file, or of the scenario, with another ending. */
    public Path suggestedFile(String ending) {
        String scenario =
                FileNames.forScenario(workspace.scenario().map(Scenario::name).orElse(""));
        Path file = openFile().orElse(Path.of(scenario + FileNames.newScenarioEnding()));
        return file.resolveSibling(FileNames.withoutExtension(file.getFileName().toString()) + ending);
    }

    /** Runs an action that leaves the scenario, after asking whether to save a recording and unsaved changes. */
    public void runIfChangesHandled(Runnable action) {
        Leaving.begin(leaving -> runIfChangesHandled(leaving, action));
    }

    /** Does the same as one of the questions before something is left. */
    public void runIfChangesHandled(Leaving leaving, Runnable action) {
        leaveQuestion.accept(leaving, () -> runIfEditsHandled(leaving, action));
    }

    private void runIfEditsHandled(Leaving leaving, Runnable action) {
        // A number that was just committed has not reached the run yet and does not count as a change.
        boolean changed = commitPendingEdit.getAsBoolean() || workspace.isChanged() || workspace.awaitsCommands();
        if (!changed) {
            action.run();
            return;
        }
        int answer = fileDialogs.showOptions(
                "unsaved", Messages.get("unsaved.question"), "unsaved.save", "unsaved.discard", "unsaved.cancel");
        if (answer == 0) {
            // The window can be used while the file is written.
            save(leaving::ask);
        } else if (answer == 1) {
            action.run();
        }
    }

    /** Returns the title of the window. */
    public String documentTitle() {
        Optional<String> name = workspace.file().map(file -> file.getFileName().toString());
        String title = name.or(() -> workspace.scenario().map(Scenario::name)).orElse(Messages.get("title.none"));
        String kind = workspace
                .scenario()
                .filter(Scenario::recorded)
                .map(run -> " " + Messages.get("title.replay"))
                .orElse("");
        return TextDirection.leftToRight(title + (workspace.isChanged() ? "*" : "") + kind + " – Faultline");
    }
}
