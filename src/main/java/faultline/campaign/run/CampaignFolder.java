package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.engine.ControllerProviders;
import faultline.io.AtomicFile;
import faultline.io.LinkResolver;
import faultline.io.MessageException;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** The folder of a campaign: its tables, a copy of its plan, and the scenarios that replay its worst runs. */
public final class CampaignFolder {

    private final Path folder;

    /**
     * Creates a view of a folder, which need not exist.
     *
     * @param folder the folder
     */
    public CampaignFolder(Path folder) {
        this.folder = folder;
    }

    /** {@return the table with one row per run} */
    public Path runs() {
        return folder.resolve("runs.csv");
    }

    /** Returns the table of values that differ when a campaign is repeated, such as processor times. */
    Path timing() {
        return folder.resolve("timing.csv");
    }

    private Path manifest() {
        return folder.resolve("campaign.json");
    }

    /** Returns the folder of the copy of the plan. */
    Path plan() {
        return folder.resolve("plan");
    }

    Path replays() {
        return folder.resolve("replays");
    }

    /**
     * {@return the plan of this campaign, from its copy}
     *
     * @throws ScenarioException if the copy is missing or invalid
     */
    public CampaignPlan readPlan() throws ScenarioException {
        return PlanFiles.readCopy(plan());
    }

    /**
     * {@return the tables and the manifest of this campaign, which need not exist, and its other files except that of
     * the lock}
     *
     * @throws IOException if the folder cannot be read
     */
    public List<Path> files() throws IOException {
        List<Path> files = new ArrayList<>(tables());
        for (Path inside : List.of(plan(), replays())) {
            if (Files.isDirectory(inside)) {
                try (Stream<Path> listed = Files.list(inside)) {
                    listed.forEach(files::add);
                }
            }
        }
        return files;
    }

    private List<Path> tables() {
        return List.of(runs(), timing(), manifest());
    }

    /**
     * Checks that the tables do not overwrite another file.
     *
     * @param inputs the files that the campaign is made from
     * @throws IOException if a table is not a regular file, or is a link to an input or to another table
     */
    void checkTables(List<Path> inputs) throws IOException {
        for (Path table : tables()) {
            if (Files.isDirectory(table)) {
                throw new IOException(table + ": this is a folder; expected a file");
            }
            // A table is read and truncated before it is continued, and a device or a pipe may have no end.
            if (Files.exists(table) && !Files.isRegularFile(table)) {
                throw new IOException(table + ": this is not a regular file; expected a table");
            }
        }
        Optional<Path> conflict = LinkResolver.findConflict(inputs, tables());
        if (conflict.isPresent()) {
            throw new IOException(
                    conflict.get() + ": this is also another file of the campaign; expected a different file");
        }
    }

    /**
     * Checks that it can be seen whether a campaign is here.
     *
     * @throws IOException if the folder cannot be read, for example because the user has no permission
     */
    public void requireReadable() throws IOException {
        boolean unknown = !Files.exists(manifest()) && !Files.notExists(manifest());
        if (unknown && !Files.isRegularFile(folder)) {
            throw new MessageException(folder.toString(), ResultsProblem.UNREADABLE.with(), null);
        }
    }

    /**
     * {@return whether this program, with the controllers of the plan as it finds them now, would make the same runs:
     * the manifest names both with their hashes}
     *
     * @param plan the plan of this campaign
     * @throws IOException if the folder cannot be read
     */
    public boolean isOfThisProgram(CampaignPlan plan) throws IOException {
        Optional<CampaignManifest> manifest = readManifest();
        return manifest.isPresent()
                && manifest.get().hasSameRuns(CampaignManifest.of(plan, Shard.ALL), plan.controllerTypes());
    }

    /** Returns the manifest, empty if there is none. */
    Optional<CampaignManifest> readManifest() throws IOException {
        requireReadable();
        // Bytes that are not text do not belong to this campaign.
        return Files.isRegularFile(manifest())
                ? Optional.of(
                        CampaignManifest.parse(new String(Files.readAllBytes(manifest()), StandardCharsets.UTF_8)))
                : Optional.empty();
    }

    /**
     * Locks this folder until the channel is closed or the process ends. Throws an exception if another process has
     * locked it.
     */
    FileChannel lock() throws IOException {
        Files.createDirectories(folder);
        Path file = folder.resolve(".lock");
        if (Files.isDirectory(file)) {
            throw new IOException(file + ": this is a folder; expected a file");
        }
        FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        boolean locked = false;
        try {
            locked = tryLock(channel);
        } finally {
            if (!locked) {
                channel.close();
            }
        }
        if (!locked) {
            throw new IOException(folder + ": another process is making this campaign");
        }
        return channel;
    }

    private static boolean tryLock(FileChannel channel) throws IOException {
        try {
            return channel.tryLock() != null;
        } catch (OverlappingFileLockException e) {
            return false;
        }
    }

    /**
     * Writes the copy of the plan and the manifest. If there is a manifest, checks instead that it belongs to the same
     * campaign, and writes only what is missing of the copy.
     */
    void prepare(CampaignPlan plan, Shard shard, boolean resume) throws IOException {
        CampaignManifest manifest = CampaignManifest.of(plan, shard);
        Optional<CampaignManifest> earlier = readManifest();
        if (!resume && (earlier.isPresent() || Files.exists(runs()))) {
            throw new IOException(
                    folder + ": there is a campaign already; continue it with --resume, or use another folder");
        }
        if (earlier.isPresent() && !manifest.isSameCampaign(earlier.get())) {
            throw new IOException(folder + ": the campaign there has another plan, or was made by another program"
                    + " or with another jar of a controller");
        }
        Optional<Shard> earlierShard = earlier.flatMap(CampaignManifest::shard);
        if (earlier.isPresent() && !earlierShard.equals(Optional.of(shard))) {
            String part = earlierShard.map(other -> ", " + other).orElse("");
            throw new IOException(folder + ": the campaign there is another part" + part + "; expected " + shard);
        }
        if (earlier.isEmpty() && Files.exists(runs())) {
            throw new IOException(folder + ": there is a runs.csv without its campaign.json");
        }
        List<Path> inputs = new ArrayList<>(plan.files().paths());
        inputs.addAll(ControllerProviders.jars().values());
        checkTables(inputs);
        if (earlier.isEmpty()) {
            OtherFiles.requireNone(this, plan, Set.of());
        }
        removeTemporaryFiles();
        if (earlier.isEmpty()) {
            write(plan, manifest);
        } else {
            restoreCopy(plan);
        }
    }

    /** Writes the copy of the plan, and after it the manifest, which shows that the copy is complete. */
    private void write(CampaignPlan plan, CampaignManifest manifest) throws IOException {
        writeCopies(plan, plan.files().copies());
        AtomicFile.write(manifest(), manifest.text().getBytes(StandardCharsets.UTF_8));
    }

    /** Writes the files that are missing in the copy of the plan. Others stay as they are. */
    private void restoreCopy(CampaignPlan plan) throws IOException {
        Map<String, byte[]> missing = new LinkedHashMap<>(plan.files().copies());
        missing.keySet().removeIf(name -> !Files.notExists(plan().resolve(name)));
        if (!missing.isEmpty()) {
            writeCopies(plan, missing);
        }
    }

    private void writeCopies(CampaignPlan plan, Map<String, byte[]> copies) throws IOException {
        Files.createDirectories(plan());
        List<Path> files =
                copies.keySet().stream().map(name -> plan().resolve(name)).toList();
        Optional<Path> conflict = LinkResolver.findConflict(plan.files().paths(), files);
        if (conflict.isPresent()) {
            throw new IOException(conflict.get() + ": the plan is made of this file; expected another folder");
        }
        for (Map.Entry<String, byte[]> copy : copies.entrySet()) {
            AtomicFile.write(plan().resolve(copy.getKey()), copy.getValue());
        }
    }

    /** Writes the copy of the plan and the manifest of a whole campaign, given that of a part. */
    void writeMerged(CampaignPlan plan, CampaignManifest part) throws IOException {
        removeTemporaryFiles();
        write(plan, part.with(Shard.ALL));
    }

    /**
     * Removes the temporary files of a killed process at any age: the lock of this folder shows that no other campaign
     * writes here. Reports and pictures that are being written stay.
     */
    private void removeTemporaryFiles() throws IOException {
        for (Path inside : List.of(folder, plan(), replays())) {
            if (Files.isDirectory(inside)) {
                AtomicFile.deleteTemporaryFiles(inside);
            }
        }
    }

    @Override
    public String toString() {
        return folder.toString();
    }
}
