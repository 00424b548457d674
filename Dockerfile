# docker build -t restenosisfoam .
# docker run --rm -v "$PWD:/work" restenosisfoam run /usr/share/restenosisFoam/scenes/quick.toml
FROM debian:12 AS build
COPY . /source
WORKDIR /source
# What cmake/packages.txt lists for building, and what a package is made with
RUN apt-get update \
 && apt-get install -y --no-install-recommends dpkg-dev file \
      $(awk '$1 == "build" { print $2 }' cmake/packages.txt) \
 && rm -rf /var/lib/apt/lists/* \
 && cmake --preset package && cmake --build --preset package && cpack --preset package

FROM debian:12
COPY --from=build /source/build/package/*.deb /tmp/
RUN apt-get update \
 && apt-get install -y --no-install-recommends xvfb xauth /tmp/*.deb \
 && rm -rf /var/lib/apt/lists/* /tmp/*.deb
WORKDIR /work
ENTRYPOINT ["restenosisFoam"]
CMD ["--help"]
