<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Fidelity</name>
    <message numerus="yes">
        <source>Preview, sharpened in %n steps</source>
        <translation>
            <numerusform>Preview, sharpened in %n step</numerusform>
            <numerusform>Preview, sharpened in %n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n samples</source>
        <translation>
            <numerusform>, %n sample</numerusform>
            <numerusform>, %n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LinkQuestion</name>
    <message numerus="yes">
        <source>, the %n most recent</source>
        <translation>
            <numerusform>, the most recent</numerusform>
            <numerusform>, the %n most recent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Macula would ask %n archives.</source>
        <translation>
            <numerusform>Macula would ask %n archive.</numerusform>
            <numerusform>Macula would ask %n archives.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n studies by their UIDs</source>
        <translation>
            <numerusform>%n study by its UID</numerusform>
            <numerusform>%n studies by their UIDs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n studies by their accession numbers</source>
        <translation>
            <numerusform>%n study by its accession number</numerusform>
            <numerusform>%n studies by their accession numbers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Model</name>
    <message numerus="yes">
        <source>Preview of an earlier session, %n steps</source>
        <translation>
            <numerusform>Preview of an earlier session, %n step</numerusform>
            <numerusform>Preview of an earlier session, %n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview sharpening, %n steps</source>
        <translation>
            <numerusform>Preview sharpening, %n step</numerusform>
            <numerusform>Preview sharpening, %n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview not sharp yet, %n steps</source>
        <translation>
            <numerusform>Preview not sharp yet, %n step</numerusform>
            <numerusform>Preview not sharp yet, %n steps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview sharp, %n steps</source>
        <translation>
            <numerusform>Preview sharp, %n step</numerusform>
            <numerusform>Preview sharp, %n steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>QueueDialog</name>
    <message numerus="yes">
        <source>waits, after %n tries</source>
        <translation>
            <numerusform>waits, after %n try</numerusform>
            <numerusform>waits, after %n tries</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ArchiveController</name>
    <message numerus="yes">
        <source>%n images fetched</source>
        <translation>
            <numerusform>%n image fetched</numerusform>
            <numerusform>%n images fetched</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ArchivePanel</name>
    <message numerus="yes">
        <source>%n studies</source>
        <translation>
            <numerusform>%n study</numerusform>
            <numerusform>%n studies</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ArrivalBar</name>
    <message numerus="yes">
        <source>A new study arrived in %1: %2, %n images</source>
        <translation>
            <numerusform>A new study arrived in %1: %2, %n image</numerusform>
            <numerusform>A new study arrived in %1: %2, %n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A new study arrived in a folder that is watched: %1, %n images</source>
        <translation>
            <numerusform>A new study arrived in a folder that is watched: %1, %n image</numerusform>
            <numerusform>A new study arrived in a folder that is watched: %1, %n images</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> %n more arrived.</source>
        <translation>
            <numerusform> %n more arrived.</numerusform>
            <numerusform> %n more arrived.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A new study was sent by %1: %2, %n images</source>
        <translation>
            <numerusform>A new study was sent by %1: %2, %n image</numerusform>
            <numerusform>A new study was sent by %1: %2, %n images</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ConvergeNow</name>
    <message numerus="yes">
        <source>The picture is final: %Ln samples, noise %1 of black to white.</source>
        <translation>
            <numerusform>The picture is final: %Ln sample, noise %1 of black to white.</numerusform>
            <numerusform>The picture is final: %Ln samples, noise %1 of black to white.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The picture is final: %Ln samples.</source>
        <translation>
            <numerusform>The picture is final: %Ln sample.</numerusform>
            <numerusform>The picture is final: %Ln samples.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::DocumentsController</name>
    <message numerus="yes">
        <source>%n measurements were taken over from the report.</source>
        <translation>
            <numerusform>%n measurement was taken over from the report.</numerusform>
            <numerusform>%n measurements were taken over from the report.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::FollowUpController</name>
    <message numerus="yes">
        <source>What was measured before could not be read everywhere; left out were %n states.</source>
        <translation>
            <numerusform>What was measured before could not be read everywhere; left out was %n state.</numerusform>
            <numerusform>What was measured before could not be read everywhere; left out were %n states.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n studies have no date, and are left out.</source>
        <translation>
            <numerusform>%n study has no date, and is left out.</numerusform>
            <numerusform>%n studies have no date, and are left out.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::LabelMapOpener</name>
    <message numerus="yes">
        <source>%n segments are shown; the panel Segmentations (F11) lists them.</source>
        <translation>
            <numerusform>%n segment is shown; the panel Segmentations (F11) lists it.</numerusform>
            <numerusform>%n segments are shown; the panel Segmentations (F11) lists them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::LinkChoice</name>
    <message numerus="yes">
        <source>%n studies fit the link. Choose the one to fetch and open.</source>
        <translation>
            <numerusform>%n study fits the link. Choose it to fetch and open it.</numerusform>
            <numerusform>%n studies fit the link. Choose the one to fetch and open.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ManifestsController</name>
    <message numerus="yes">
        <source>The manifest names %n studies, which were all fetched. The first one is shown; macula pacs fetched lists them all.</source>
        <translation>
            <numerusform>The manifest names %n study, which was fetched. It is shown; macula pacs fetched lists it.</numerusform>
            <numerusform>The manifest names %n studies, which were all fetched. The first one is shown; macula pacs fetched lists them all.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ModelExport</name>
    <message numerus="yes">
        <source> %Ln of its Gaussians have numbers that this format cannot hold; they were limited.</source>
        <translation>
            <numerusform> %Ln of its Gaussians has numbers that this format cannot hold; they were limited.</numerusform>
            <numerusform> %Ln of its Gaussians have numbers that this format cannot hold; they were limited.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::MovieExport</name>
    <message numerus="yes">
        <source>%Ln pictures are in %1.</source>
        <translation>
            <numerusform>%Ln picture is in %1.</numerusform>
            <numerusform>%Ln pictures are in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::MoviePanel</name>
    <message numerus="yes">
        <source>%Ln pictures</source>
        <translation>
            <numerusform>%Ln picture</numerusform>
            <numerusform>%Ln pictures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PictureDialog</name>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanesController</name>
    <message numerus="yes">
        <source>%n planes are written to %1.</source>
        <translation>
            <numerusform>%n plane is written to %1.</numerusform>
            <numerusform>%n planes are written to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanesDialog</name>
    <message numerus="yes">
        <source>%n images of %1 × %2 pixels of %3 mm, over the area that the pane shows.</source>
        <translation>
            <numerusform>%n image of %1 × %2 pixels of %3 mm, over the area that the pane shows.</numerusform>
            <numerusform>%n images of %1 × %2 pixels of %3 mm, over the area that the pane shows.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetListModel</name>
    <message numerus="yes">
        <source>%1, %n presets, shown</source>
        <translation>
            <numerusform>%1, %n preset, shown</numerusform>
            <numerusform>%1, %n presets, shown</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n presets, folded</source>
        <translation>
            <numerusform>%1, %n preset, folded</numerusform>
            <numerusform>%1, %n presets, folded</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PriorsController</name>
    <message numerus="yes">
        <source>%n other studies of this patient</source>
        <translation>
            <numerusform>%n other study of this patient</numerusform>
            <numerusform>%n other studies of this patient</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other studies of this patient are listed in the panel Archive.</source>
        <translation>
            <numerusform>%n other study of this patient is listed in the panel Archive.</numerusform>
            <numerusform>%n other studies of this patient are listed in the panel Archive.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ProgramRun</name>
    <message numerus="yes">
        <source>The program took longer than %n minutes, and was stopped.</source>
        <translation>
            <numerusform>The program took longer than %n minute, and was stopped.</numerusform>
            <numerusform>The program took longer than %n minutes, and was stopped.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::QueueDialog</name>
    <message numerus="yes">
        <source>Remove %n objects without sending them?</source>
        <translation>
            <numerusform>Remove %n object without sending it?</numerusform>
            <numerusform>Remove %n objects without sending them?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ReceiveController</name>
    <message numerus="yes">
        <source>%n images are arriving at port %1</source>
        <translation>
            <numerusform>%n image is arriving at port %1</numerusform>
            <numerusform>%n images are arriving at port %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connections were turned away. The last: %1</source>
        <translation>
            <numerusform>%n connection was turned away: %1</numerusform>
            <numerusform>%n connections were turned away. The last: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects were refused, and their sender was told so.</source>
        <translation>
            <numerusform>%n object was refused, and its sender was told so.</numerusform>
            <numerusform>%n objects were refused, and their sender was told so.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationKeeper</name>
    <message numerus="yes">
        <source>There are %n segmentations of this volume: F11.</source>
        <translation>
            <numerusform>There is a segmentation of this volume: F11.</numerusform>
            <numerusform>There are %n segmentations of this volume: F11.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationsController</name>
    <message numerus="yes">
        <source>A segmentation object for the archive: the %n segments of what is shown, on the voxels of this series, with labels, colours and codes.</source>
        <translation>
            <numerusform>A segmentation object for the archive: the segment that is shown, on the voxels of this series, with label, colour and code.</numerusform>
            <numerusform>A segmentation object for the archive: the %n segments of what is shown, on the voxels of this series, with labels, colours and codes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentingController</name>
    <message numerus="yes">
        <source>The program made %n segments. Nobody has checked them yet.</source>
        <translation>
            <numerusform>The program made %n segment. Nobody has checked it yet.</numerusform>
            <numerusform>The program made %n segments. Nobody has checked them yet.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentingPanel</name>
    <message numerus="yes">
        <source>%n voxels have no value, and are left out of these.</source>
        <translation>
            <numerusform>%n voxel has no value, and is left out of these.</numerusform>
            <numerusform>%n voxels have no value, and are left out of these.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SendController</name>
    <message numerus="yes">
        <source>%n objects are stored.</source>
        <translation>
            <numerusform>%n object is stored.</numerusform>
            <numerusform>%n objects are stored.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects are stored in %1.</source>
        <translation>
            <numerusform>%n object is stored in %1.</numerusform>
            <numerusform>%n objects are stored in %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The archive refused %n objects; File, Waiting for Archives says why.</source>
        <translation>
            <numerusform>The archive refused %n object; File, Waiting for Archives says why.</numerusform>
            <numerusform>The archive refused %n objects; File, Waiting for Archives says why.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects wait in the queue.</source>
        <translation>
            <numerusform>%n object waits in the queue.</numerusform>
            <numerusform>%n objects wait in the queue.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SendDialog</name>
    <message numerus="yes">
        <source>%n files</source>
        <translation>
            <numerusform>%n file</numerusform>
            <numerusform>%n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Send %n objects to %1, of:</source>
        <translation>
            <numerusform>Send %n object to %1, of:</numerusform>
            <numerusform>Send %n objects to %1, of:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Segmen&amp;tation (%n segments)</source>
        <translation>
            <numerusform>Segmen&amp;tation (%n segment)</numerusform>
            <numerusform>Segmen&amp;tation (%n segments)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SeriesStrip</name>
    <message numerus="yes">
        <source>%n images</source>
        <translation>
            <numerusform>%n image</numerusform>
            <numerusform>%n images</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SettingsDialog</name>
    <message numerus="yes">
        <source>%1: %n samples</source>
        <translation>
            <numerusform>%1: %n sample</numerusform>
            <numerusform>%1: %n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::StatusController</name>
    <message numerus="yes">
        <source>, %n samples left out</source>
        <translation>
            <numerusform>, %n sample left out</numerusform>
            <numerusform>, %n samples left out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyFetcher</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferCurve</name>
    <message numerus="yes">
        <source>%n points; none is selected. Arrows shift and widen all of them, Tab goes through them.</source>
        <translation>
            <numerusform>%n point; it is not selected. Arrows shift it, Tab goes to it.</numerusform>
            <numerusform>%n points; none is selected. Arrows shift and widen all of them, Tab goes through them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::WaitingBar</name>
    <message numerus="yes">
        <source>%n objects wait for %1.</source>
        <translation>
            <numerusform>%n object waits for %1.</numerusform>
            <numerusform>%n objects wait for %1.</numerusform>
        </translation>
    </message>
</context>
</TS>
