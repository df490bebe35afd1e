package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.io.AtomicFile;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** The folder of a campaign: its tables, a copy of its plan, and the scenarios that replay its worst runs. */
public final class CampaignFolder {

    private final Path folder;

    public CampaignFolder(Path folder) {
        this.folder = folder;
    }

    /** Returns the table with one row a run. */
    public Path runs() {
        return folder.resolve("runs.csv");
    }

    /** Returns the table of what is not the same in every run of the program. */
    Path timing() {
        return folder.resolve("timing.csv");
    }

    private Path manifest() {
        return folder.resolve("campaign.json");
    }

    private Path plan() {
        return folder.resolve("plan");
    }

    Path replays() {
        return folder.resolve("replays");
    }

    /**
     * Returns the plan of this campaign, from its copy.
     *
     * @throws ScenarioException if the copy is not there or not good
     */
    public CampaignPlan readPlan() throws ScenarioException {
        return PlanFiles.readCopy(plan());
    }

    /** Returns the text of the manifest, empty if there is none. */
    Optional<String> readManifest() throws IOException {
        return Files.isRegularFile(manifest()) ? Optional.of(Files.readString(manifest())) : Optional.empty();
    }

    /**
     * Takes this folder for a process of its own, until the lock is closed or the process ends.
     *
     * @throws IOException if another process has it
     */
    FileChannel lock() throws IOException {
        Files.createDirectories(folder);
        FileChannel channel =
                FileChannel.open(folder.resolve(".lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileLock lock;
        try {
            lock = channel.tryLock();
        } catch (OverlappingFileLockException e) {
            lock = null;
        }
        if (lock == null) {
            channel.close();
            throw new IOException(folder + ": another process is making this campaign");
        }
        return channel;
    }

    /**
     * Writes the copy of the plan and the manifest, or checks that those that are there are of the same campaign.
     *
     * @param resume whether the folder may hold a begun campaign
     * @throws IOException if the folder cannot be used, in one sentence
     */
    void prepare(CampaignPlan plan, Shard shard, boolean resume) throws IOException {
        String text = CampaignManifest.text(plan, shard);
        Optional<String> earlier = readManifest();
        if (!resume && (earlier.isPresent() || Files.exists(runs()))) {
            throw new IOException(folder
                    + ": there is a campaign already; --resume goes on with it, another folder begins another one");
        }
        if (earlier.isPresent() && !CampaignManifest.sameCampaign(earlier.get(), text)) {
            throw new IOException(folder + ": the campaign there has another plan or was made by another program");
        }
        if (earlier.isPresent() && !CampaignManifest.shard(earlier.get()).equals(Optional.of(shard))) {
            throw new IOException(folder + ": the campaign there is another part, not " + shard);
        }
        if (earlier.isEmpty() && Files.exists(runs())) {
            throw new IOException(folder + ": there is a runs.csv without its campaign.json");
        }
        if (earlier.isEmpty()) {
            write(plan, text);
        }
    }

    /** Writes the copy of the plan, and after it the manifest, which tells that the copy is whole. */
    private void write(CampaignPlan plan, String manifest) throws IOException {
        removeTemporaryFiles(folder);
        Files.createDirectories(plan());
        for (Map.Entry<String, byte[]> file : plan.files().copies().entrySet()) {
            writeFile(plan().resolve(file.getKey()), file.getValue());
        }
        writeFile(manifest(), manifest.getBytes(StandardCharsets.UTF_8));
    }

    /** Writes the copy of the plan and the manifest of a whole campaign. */
    void writeMerged(CampaignPlan plan) throws IOException {
        write(plan, CampaignManifest.text(plan, Shard.ALL));
    }

    /** Writes a file whole or not at all, and forces it to the disk. */
    static void writeFile(Path file, byte[] bytes) throws IOException {
        try (AtomicFile out = AtomicFile.create(file)) {
            out.stream().write(bytes);
            out.commit();
        }
        force(file);
    }

    static void force(Path file) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            channel.force(true);
        }
    }

    /** Removes what a killed process left half written. */
    private static void removeTemporaryFiles(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder, 2)) {
            List<Path> left = files.filter(file -> file.getFileName().toString().matches("\\..+\\.tmp"))
                    .toList();
            for (Path file : left) {
                Files.deleteIfExists(file);
            }
        }
    }

    @Override
    public String toString() {
        return folder.toString();
    }
}
